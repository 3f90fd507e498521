//! The window's fonts: Inter with tabular digits in two weights, and the icons.

use eframe::egui::{Context, FontData, FontDefinitions, FontFamily, FontId};
use std::sync::Arc;

const REGULAR: &[u8] = include_bytes!("../../../assets/fonts/Inter-Regular.otf");
const SEMIBOLD: &[u8] = include_bytes!("../../../assets/fonts/Inter-SemiBold.otf");
const ICONS: &[u8] = include_bytes!("../../../assets/fonts/Icons.ttf");

const SEMIBOLD_NAME: &str = "Inter SemiBold";
const ICONS_NAME: &str = "Icons";

pub(super) fn install(ctx: &Context) {
    let mut fonts = FontDefinitions::empty();
    for (name, bytes) in [
        ("Inter", REGULAR),
        (SEMIBOLD_NAME, SEMIBOLD),
        (ICONS_NAME, ICONS),
    ] {
        let data = Arc::new(FontData::from_static(bytes));
        fonts.font_data.insert(name.to_owned(), data);
    }
    let families = [
        (FontFamily::Proportional, ["Inter", ICONS_NAME]),
        // The digits are tabular, which is all that is asked of a monospace
        // font here.
        (FontFamily::Monospace, ["Inter", ICONS_NAME]),
        (family(SEMIBOLD_NAME), [SEMIBOLD_NAME, ICONS_NAME]),
        (family(ICONS_NAME), [ICONS_NAME, "Inter"]),
    ];
    for (family, names) in families {
        let names = names.map(str::to_owned).to_vec();
        fonts.families.insert(family, names);
    }
    ctx.set_fonts(fonts);
}

/// The fonts as rules of a style sheet, for a picture that brings them along.
#[cfg(target_arch = "wasm32")]
pub fn fonts_for_svg() -> String {
    use base64::Engine as _;
    use base64::engine::general_purpose::STANDARD;
    let rule = |(weight, bytes): (u32, &[u8])| {
        let data = STANDARD.encode(bytes);
        format!(
            "@font-face{{font-family:Inter;font-weight:{weight};\
             src:url(data:font/otf;base64,{data})}}"
        )
    };
    [(400, REGULAR), (600, SEMIBOLD)].map(rule).concat()
}

/// The heavier of the two weights.
pub fn semibold(size: f32) -> FontId {
    FontId::new(size, family(SEMIBOLD_NAME))
}

/// The font of [`super::icons`].
pub fn icon_font(size: f32) -> FontId {
    FontId::new(size, family(ICONS_NAME))
}

fn family(name: &str) -> FontFamily {
    FontFamily::Name(name.into())
}
