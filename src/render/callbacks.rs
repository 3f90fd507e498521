//! The passes as egui's paint callbacks. The only file here that knows egui.

use super::camera::Camera;
use super::field::{FieldOutput, FieldPass, FieldPicture};
use super::mesh::Mesh;
use super::solid::{SolidPass, SolidPicture};
use super::targets;
use crate::geometry::{Obstacle, Vector};
use crate::view::{Bounds, Frame, Theme};
use eframe::egui::epaint::{PaintCallback, PaintCallbackInfo};
use eframe::egui::{self, Rect};
use eframe::egui_wgpu::{
    Callback, CallbackResources, CallbackTrait, RenderState, ScreenDescriptor,
};
use eframe::wgpu;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Puts the passes where the callbacks find them. To be called once, when the
/// window opens, for a window without multisampling and depth of its own
/// (eframe's default). Without it the callbacks draw nothing.
pub fn install(state: &RenderState) {
    let (device, format) = (&state.device, state.target_format);
    let features = |format| state.adapter.get_texture_format_features(format).flags;
    let four = [targets::COLOUR, targets::DEPTH]
        .into_iter()
        .all(|format| features(format).sample_count_supported(4));
    let samples = if four { 4 } else { 1 };
    let resources = &mut state.renderer.write().callback_resources;
    resources.insert(FieldPass::new(device, format, FieldOutput::Picture));
    resources.insert(SolidTarget { format, samples });
}

/// What [`SolidPass`] is made for, once a view in space is opened: its shaders
/// take a driver in software a good part of the time that the window has to
/// open.
#[derive(Clone, Copy)]
struct SolidTarget {
    format: wgpu::TextureFormat,
    samples: u32,
}

/// The pass of views in space; `None` without [`install`].
fn solid_pass<'a>(
    device: &wgpu::Device,
    resources: &'a mut CallbackResources,
) -> Option<&'a mut SolidPass> {
    if !resources.contains::<SolidPass>() {
        let SolidTarget { format, samples } = *resources.get()?;
        resources.insert(SolidPass::new(device, format, samples));
    }
    resources.get_mut()
}

/// The clearance field in a rectangle of the window, as a frame in points shows
/// it.
pub fn field_callback(
    rect: Rect,
    frame: &Frame,
    obstacles: &[Obstacle],
    theme: Theme,
) -> PaintCallback {
    let corner = |at: egui::Pos2| Vector::new(f64::from(at.x), f64::from(at.y));
    let window = Bounds {
        least: corner(rect.min),
        most: corner(rect.max),
    };
    let picture = FieldPicture::new(window, frame, obstacles, theme);
    Callback::new_paint_callback(
        rect,
        Field {
            picture,
            slot: AtomicUsize::new(usize::MAX),
        },
    )
}

/// The robot in space in a rectangle of the window. A mesh that is the same
/// value as in the frame before is not sent again.
pub fn solid_callback(rect: Rect, mesh: Arc<Mesh>, camera: Camera, theme: Theme) -> PaintCallback {
    Callback::new_paint_callback(
        rect,
        Solid {
            picture: SolidPicture {
                mesh,
                camera,
                theme,
            },
            rect,
            slot: AtomicUsize::new(usize::MAX),
        },
    )
}

struct Field {
    picture: FieldPicture,
    /// Which of the frame's pictures this is; set while it is prepared.
    slot: AtomicUsize,
}

impl CallbackTrait for Field {
    fn prepare(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        screen: &ScreenDescriptor,
        _encoder: &mut wgpu::CommandEncoder,
        resources: &mut CallbackResources,
    ) -> Vec<wgpu::CommandBuffer> {
        if let Some(pass) = resources.get_mut::<FieldPass>() {
            let pixels_per_point = f64::from(screen.pixels_per_point);
            let slot = pass.prepare(device, queue, &self.picture, pixels_per_point);
            self.slot.store(slot, Ordering::Relaxed);
        }
        Vec::new()
    }

    fn finish_prepare(
        &self,
        _device: &wgpu::Device,
        _queue: &wgpu::Queue,
        _encoder: &mut wgpu::CommandEncoder,
        resources: &mut CallbackResources,
    ) -> Vec<wgpu::CommandBuffer> {
        if let Some(pass) = resources.get_mut::<FieldPass>() {
            pass.prepared();
        }
        Vec::new()
    }

    fn paint(
        &self,
        _info: PaintCallbackInfo,
        target: &mut wgpu::RenderPass<'static>,
        resources: &CallbackResources,
    ) {
        if let Some(pass) = resources.get::<FieldPass>() {
            pass.paint(self.slot.load(Ordering::Relaxed), target);
        }
    }
}

struct Solid {
    picture: SolidPicture,
    rect: Rect,
    slot: AtomicUsize,
}

impl CallbackTrait for Solid {
    fn prepare(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        screen: &ScreenDescriptor,
        encoder: &mut wgpu::CommandEncoder,
        resources: &mut CallbackResources,
    ) -> Vec<wgpu::CommandBuffer> {
        if let Some(pass) = solid_pass(device, resources) {
            let pixels = self.rect * screen.pixels_per_point;
            let place = [pixels.min.into(), pixels.size().into()];
            let slot = pass.prepare(device, queue, encoder, &self.picture, place);
            self.slot.store(slot, Ordering::Relaxed);
        }
        Vec::new()
    }

    fn finish_prepare(
        &self,
        _device: &wgpu::Device,
        _queue: &wgpu::Queue,
        _encoder: &mut wgpu::CommandEncoder,
        resources: &mut CallbackResources,
    ) -> Vec<wgpu::CommandBuffer> {
        if let Some(pass) = resources.get_mut::<SolidPass>() {
            pass.prepared();
        }
        Vec::new()
    }

    fn paint(
        &self,
        _info: PaintCallbackInfo,
        target: &mut wgpu::RenderPass<'static>,
        resources: &CallbackResources,
    ) {
        if let Some(pass) = resources.get::<SolidPass>() {
            pass.paint(self.slot.load(Ordering::Relaxed), target);
        }
    }
}
