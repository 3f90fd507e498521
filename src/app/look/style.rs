//! The window's colours and measures, by day and by night, on a grid of 4 pt.

use super::fonts::{icon_font, semibold};
use crate::view::{Colour, Role, Standing, Theme};
use eframe::egui::style::{HandleShape, ScrollStyle, WidgetVisuals};
use eframe::egui::{
    self, Button, Color32, Context, CornerRadius, FontFamily, FontId, Margin, Response, RichText,
    Shadow, Stroke, Style, TextStyle, Ui, Vec2, Visuals,
};

/// What the program moves, it moves in this time.
pub const MOTION_SECONDS: f32 = 0.14;

/// The least height of what can be clicked, in points …
const FOR_POINTERS: f32 = 28.0;
/// … and of what can be touched.
const FOR_FINGERS: f32 = 32.0;

/// The colours of panels and controls; the picture's are in
/// [`crate::view::Palette`], from which these are derived where they are the
/// same thing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tokens {
    /// Behind the canvas.
    pub canvas: Color32,
    /// Behind panels.
    pub panel: Color32,
    /// Behind menus, windows and tips.
    pub raised: Color32,
    /// Behind fields and rails.
    pub sunken: Color32,
    /// Lines between regions.
    pub line: Color32,
    /// Controls under the pointer.
    pub hover: Color32,
    /// Controls that are held.
    pub held: Color32,
    /// Titles and numbers.
    pub text: Color32,
    /// Units, captions.
    pub muted: Color32,
    /// What can be touched, and the cable.
    pub accent: Color32,
    /// Behind what is selected.
    pub accent_soft: Color32,
    /// What presses, where there is no multiplier to show.
    pub contact: Color32,
    /// Warnings, always with a word.
    pub warning: Color32,
    /// Errors, always with a way out.
    pub error: Color32,
    /// All is well.
    pub good: Color32,
    /// The robot in the other mechanics: Okabe and Ito's purple, as bright as the
    /// theme asks for.
    pub other: Color32,
    /// Pinned robots: hues of Okabe and Ito's, too.
    pub ghosts: [Color32; 4],
}

/// Colours from their hexadecimal numbers.
fn hues(numbers: [u32; 4]) -> [Color32; 4] {
    numbers.map(|number| {
        let [_, r, g, b] = number.to_be_bytes();
        Color32::from_rgb(r, g, b)
    })
}

impl Tokens {
    /// The tokens of a theme.
    pub fn of(theme: Theme) -> Self {
        let palette = theme.palette();
        let accent = theme.style(Role::Cable, &Standing::Certified).stroke;
        let accent = accent.map_or(Color32::BLUE, colour);
        let common = Self {
            canvas: colour(palette.background),
            panel: Color32::from_rgb(0xf3, 0xf3, 0xef),
            raised: Color32::from_rgb(0xff, 0xff, 0xfd),
            sunken: Color32::from_rgb(0xe9, 0xe9, 0xe4),
            line: Color32::from_rgb(0xe0, 0xe0, 0xda),
            hover: Color32::from_rgb(0xe6, 0xe6, 0xe1),
            held: Color32::from_rgb(0xda, 0xda, 0xd4),
            text: colour(palette.text),
            muted: colour(palette.muted),
            accent,
            accent_soft: Color32::from_rgb(0xd8, 0xe5, 0xfb),
            contact: colour(theme.contact(0.6)),
            warning: colour(palette.warning),
            error: Color32::from_rgb(0xb4, 0x23, 0x2a),
            good: Color32::from_rgb(0x1b, 0x7f, 0x5c),
            other: Color32::from_rgb(0xa0, 0x4a, 0x84),
            ghosts: hues([0x00_7f_5f, 0xc8_52_00, 0x00_72_b2, 0xa0_4a_84]),
        };
        match theme {
            Theme::Light => common,
            Theme::Dark => Self {
                panel: Color32::from_rgb(0x1b, 0x1e, 0x24),
                raised: Color32::from_rgb(0x23, 0x27, 0x2f),
                sunken: Color32::from_rgb(0x11, 0x13, 0x17),
                line: Color32::from_rgb(0x2b, 0x2f, 0x38),
                hover: Color32::from_rgb(0x2a, 0x2e, 0x37),
                held: Color32::from_rgb(0x35, 0x3a, 0x45),
                accent_soft: Color32::from_rgb(0x22, 0x38, 0x5c),
                error: Color32::from_rgb(0xff, 0x7b, 0x72),
                good: Color32::from_rgb(0x4f, 0xc0, 0x98),
                other: Color32::from_rgb(0xe6, 0x9a, 0xcb),
                ghosts: hues([0x2f_d0_a2, 0xff_8a_3c, 0x56_b4_e9, 0xe6_9a_cb]),
                ..common
            },
        }
    }

    /// The tokens of the theme that a part of the window is drawn in.
    pub fn in_ui(ui: &Ui) -> Self {
        Self::of(theme_of(ui))
    }
}

/// A picture's colour as the window's.
pub fn colour(colour: Colour) -> Color32 {
    let [r, g, b] = colour.rgb;
    Color32::from_rgba_unmultiplied(r, g, b, (255.0 * colour.opacity).round() as u8)
}

/// The theme that a part of the window is drawn in.
pub fn theme_of(ui: &Ui) -> Theme {
    if ui.visuals().dark_mode {
        Theme::Dark
    } else {
        Theme::Light
    }
}

/// An icon as text, at the size of a control's.
pub fn icon(glyph: &str) -> RichText {
    RichText::new(glyph).font(icon_font(16.0))
}

/// A button that shows an icon, with its name (and its shortcut) as its tip.
pub fn icon_button(ui: &mut Ui, glyph: &str, name: &str) -> Response {
    let size = Vec2::splat(ui.spacing().interact_size.y);
    let button = Button::new(icon(glyph)).frame_when_inactive(false);
    let response = ui.add_sized(size, button).on_hover_text(name);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, ui.is_enabled(), name));
    response
}

/// Makes controls large enough for fingers; for good, since where there was a
/// finger there will be more.
pub fn fit_fingers(ctx: &Context) {
    if ctx.global_style().spacing.interact_size.y < FOR_FINGERS {
        ctx.all_styles_mut(|style| style.spacing.interact_size.y = FOR_FINGERS);
    }
}

/// Whether controls are large enough for fingers.
pub fn fits_fingers(ui: &Ui) -> bool {
    ui.spacing().interact_size.y >= FOR_FINGERS
}

pub(super) fn install(ctx: &Context) {
    for (theme, of) in [
        (egui::Theme::Light, Theme::Light),
        (egui::Theme::Dark, Theme::Dark),
    ] {
        let tokens = Tokens::of(of);
        ctx.style_mut_of(theme, |style| shape(style, &tokens, of));
    }
}

fn shape(style: &mut Style, tokens: &Tokens, theme: Theme) {
    style.text_styles = [
        (
            TextStyle::Small,
            FontId::new(12.0, FontFamily::Proportional),
        ),
        (TextStyle::Body, FontId::new(14.0, FontFamily::Proportional)),
        (
            TextStyle::Button,
            FontId::new(14.0, FontFamily::Proportional),
        ),
        (
            TextStyle::Monospace,
            FontId::new(14.0, FontFamily::Proportional),
        ),
        (TextStyle::Heading, semibold(18.0)),
    ]
    .into();
    style.drag_value_text_style = TextStyle::Body;
    style.animation_time = MOTION_SECONDS;
    let spacing = &mut style.spacing;
    spacing.item_spacing = Vec2::new(8.0, 4.0);
    spacing.button_padding = Vec2::new(8.0, 4.0);
    spacing.interact_size = Vec2::new(32.0, FOR_POINTERS);
    spacing.menu_margin = Margin::same(8);
    spacing.window_margin = Margin::same(16);
    spacing.indent = 16.0;
    spacing.slider_rail_height = 4.0;
    spacing.icon_width = 18.0;
    spacing.icon_width_inner = 10.0;
    spacing.tooltip_width = 320.0;
    spacing.scroll = ScrollStyle::thin();
    style.interaction.tooltip_delay = 0.35;
    style.visuals = visuals(tokens, theme);
}

fn visuals(tokens: &Tokens, theme: Theme) -> Visuals {
    let mut visuals = match theme {
        Theme::Light => Visuals::light(),
        Theme::Dark => Visuals::dark(),
    };
    let radius = CornerRadius::same(6);
    let control = |fill: Color32, edge: Color32, text: Color32| WidgetVisuals {
        bg_fill: fill,
        weak_bg_fill: fill,
        bg_stroke: Stroke::new(1.0, edge),
        corner_radius: radius,
        fg_stroke: Stroke::new(1.5, text),
        expansion: 0.0,
    };
    let widgets = &mut visuals.widgets;
    widgets.noninteractive = control(tokens.panel, tokens.line, tokens.text);
    widgets.inactive = control(tokens.sunken, Color32::TRANSPARENT, tokens.text);
    widgets.hovered = control(tokens.hover, tokens.line, tokens.text);
    widgets.active = control(tokens.held, tokens.accent, tokens.text);
    widgets.open = control(tokens.hover, tokens.line, tokens.text);
    visuals.override_text_color = None;
    visuals.weak_text_color = Some(tokens.muted);
    visuals.selection.bg_fill = tokens.accent_soft;
    visuals.selection.stroke = Stroke::new(1.5, tokens.accent);
    visuals.hyperlink_color = tokens.accent;
    visuals.faint_bg_color = tokens.hover;
    visuals.extreme_bg_color = tokens.sunken;
    visuals.text_edit_bg_color = Some(tokens.sunken);
    visuals.code_bg_color = tokens.sunken;
    visuals.warn_fg_color = tokens.warning;
    visuals.error_fg_color = tokens.error;
    visuals.panel_fill = tokens.panel;
    visuals.window_fill = tokens.raised;
    visuals.window_stroke = Stroke::new(1.0, tokens.line);
    visuals.window_corner_radius = CornerRadius::same(10);
    visuals.menu_corner_radius = CornerRadius::same(8);
    let shadow = match theme {
        Theme::Light => Color32::from_black_alpha(28),
        Theme::Dark => Color32::from_black_alpha(110),
    };
    visuals.window_shadow = Shadow {
        offset: [0, 8],
        blur: 28,
        spread: 0,
        color: shadow,
    };
    visuals.popup_shadow = Shadow {
        offset: [0, 4],
        blur: 14,
        spread: 0,
        color: shadow,
    };
    visuals.slider_trailing_fill = true;
    visuals.handle_shape = HandleShape::Circle;
    visuals.indent_has_left_vline = false;
    visuals
}
