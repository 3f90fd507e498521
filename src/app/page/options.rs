//! How the window draws in a browser: with WebGPU where there is it, else with
//! WebGL 2, and asking of either no more than it has.

use eframe::WebOptions;
use eframe::egui_wgpu::{WgpuSetup, WgpuSetupCreateNew};
use eframe::wgpu::{Adapter, Backend, Backends, DeviceDescriptor, Limits};
use std::sync::Arc;

/// The greatest side of a texture that is asked for, in pixels: that of a
/// window over two wide screens.
const WIDEST: u32 = 8192;

/// Options for eframe.
pub fn of(webgl_only: bool) -> WebOptions {
    let mut setup = WgpuSetupCreateNew::without_display_handle();
    setup.instance_descriptor.backends = match webgl_only {
        true => Backends::GL,
        false => Backends::BROWSER_WEBGPU | Backends::GL,
    };
    setup.device_descriptor = Arc::new(device);
    let mut options = WebOptions::default();
    options.wgpu_options.wgpu_setup = WgpuSetup::CreateNew(setup);
    options
}

/// What is asked of a graphics device: what both renderers promise, but for
/// textures as wide as the window, on weak devices as wide as they have.
fn device(adapter: &Adapter) -> DeviceDescriptor<'static> {
    let promised = match adapter.get_info().backend {
        Backend::Gl => Limits::downlevel_webgl2_defaults(),
        _ => Limits::default(),
    };
    let asked = Limits {
        max_texture_dimension_2d: WIDEST,
        ..promised
    };
    DeviceDescriptor {
        label: Some("window"),
        required_limits: asked.or_worse_values_from(&adapter.limits()),
        ..DeviceDescriptor::default()
    }
}
