//! The pass that draws the clearance field f(x) of the obstacles, behind
//! everything else. What it reads is packed by [`super::cells`].

use super::cells::{WIDTH, packed};
use super::gpu;
use super::slots::Slots;
use crate::geometry::{Obstacle, Vector};
use crate::view::{Bounds, Colour, Frame, Role, Standing, Theme, one_two_five};
use bytemuck::{Pod, Zeroable};
use eframe::wgpu;

/// The greatest distance between contour lines, in the frame's pixels.
const SPACING: f64 = 36.0;
/// Over how many contour lines tint and lines fade to 1/e.
const REACH: f64 = 3.0;

/// The distance between contour lines in a frame, in metres: 1, 2 or 5 times
/// a power of ten.
pub fn contour_spacing(frame: &Frame) -> f64 {
    one_two_five(SPACING / frame.scale)
}

/// A picture of the field as plain data.
#[derive(Clone, Debug)]
pub struct FieldPicture {
    uniforms: Uniforms,
    /// The window on the screen, in the frame's pixels.
    window: Bounds,
    /// The frame's pixels in a metre.
    scale: f64,
    texels: Vec<[f32; 4]>,
}

/// What a pass draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FieldOutput {
    /// The tint and the contour lines, with opacity.
    Picture,
    /// The clearance, in metres, in the red channel of a float target.
    Clearance,
}

/// As in the shader.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Uniforms {
    middle: [f32; 2],
    half_size: [f32; 2],
    pixel: f32,
    spacing: f32,
    reach: f32,
    stronger: f32,
    tint: [f32; 4],
    line: [f32; 4],
    surface: [f32; 4],
    encodes: f32,
    unused: [f32; 3],
}

impl FieldPicture {
    /// The field in the part `window` of the screen, in the frame's pixels.
    pub fn new(window: Bounds, frame: &Frame, obstacles: &[Obstacle], theme: Theme) -> Self {
        let shown = Bounds::of(window.corners().map(|corner| frame.to_world(corner)));
        let palette = theme.palette();
        let edge = theme.style(Role::Obstacle(0), &Standing::Certified).stroke;
        let (tint, line) = match theme {
            Theme::Light => (0.11, 0.42),
            Theme::Dark => (0.12, 0.36),
        };
        let rgba = |colour: Colour, opacity: f64| {
            let [red, green, blue] = colour.rgb.map(|part| f32::from(part) / 255.0);
            [red, green, blue, opacity as f32]
        };
        let spacing = contour_spacing(frame);
        let half_size = 0.5 * shown.size();
        let uniforms = Uniforms {
            half_size: [half_size.x as f32, half_size.y as f32],
            spacing: spacing as f32,
            reach: (REACH * spacing) as f32,
            stronger: 5.0,
            tint: rgba(palette.quiet, tint),
            line: rgba(palette.quiet, line),
            surface: rgba(edge.unwrap_or(palette.quiet), 1.0),
            ..Uniforms::zeroed()
        };
        Self {
            uniforms,
            window,
            scale: frame.scale,
            texels: packed(obstacles, &shown),
        }
    }

    /// The uniforms for a target with so many of its pixels in one of the
    /// frame's.
    fn uniforms(&self, pixels_per_point: f64, format: wgpu::TextureFormat) -> Uniforms {
        let middle: Vector = pixels_per_point * self.window.centre();
        Uniforms {
            middle: [middle.x as f32, middle.y as f32],
            pixel: (1.0 / (self.scale * pixels_per_point)) as f32,
            encodes: if format.is_srgb() { 1.0 } else { 0.0 },
            ..self.uniforms
        }
    }
}

/// The pass: its pipeline, and the resources of each picture.
pub struct FieldPass {
    pipeline: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
    format: wgpu::TextureFormat,
    slots: Slots<Slot>,
}

struct Slot {
    uniforms: wgpu::Buffer,
    texture: wgpu::Texture,
    group: wgpu::BindGroup,
}

impl FieldPass {
    /// A pass into single-sampled targets of a format, without depth.
    pub fn new(device: &wgpu::Device, format: wgpu::TextureFormat, output: FieldOutput) -> Self {
        let module = gpu::shader(device, "field", include_str!("../../shaders/field.wgsl"));
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("field"),
            entries: &[
                gpu::uniforms_entry(0),
                gpu::texture_entry(1, wgpu::TextureSampleType::Float { filterable: false }),
            ],
        });
        let (fragment, blend) = match output {
            FieldOutput::Picture => (
                "fs_field",
                Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
            ),
            FieldOutput::Clearance => ("fs_clearance", None),
        };
        let pipeline = gpu::Pipeline {
            label: "field",
            module: &module,
            layout: &layout,
            vertex: "vs_field",
            buffers: &[],
            fragment: Some((fragment, format, blend)),
            depth: None,
            cull: None,
            samples: 1,
        };
        Self {
            pipeline: pipeline.create(device),
            layout,
            format,
            slots: Slots::new(),
        }
    }

    /// Sends a picture's data and gives the index to paint it by.
    /// `pixels_per_point`: the target's pixels in one of the frame's.
    pub fn prepare(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        picture: &FieldPicture,
        pixels_per_point: f64,
    ) -> usize {
        let rows = (picture.texels.len() / WIDTH) as u32;
        let (layout, format) = (&self.layout, self.format);
        let (index, slot) = self.slots.next(|| slot(device, layout, rows));
        if slot.texture.height() < rows {
            *slot = self::slot(device, layout, rows);
        }
        let uniforms = picture.uniforms(pixels_per_point, format);
        queue.write_buffer(&slot.uniforms, 0, bytemuck::bytes_of(&uniforms));
        queue.write_texture(
            slot.texture.as_image_copy(),
            bytemuck::cast_slice(&picture.texels),
            wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(16 * WIDTH as u32),
                rows_per_image: None,
            },
            wgpu::Extent3d {
                width: WIDTH as u32,
                height: rows,
                depth_or_array_layers: 1,
            },
        );
        index
    }

    /// To be called when all pictures of a frame are prepared.
    pub fn prepared(&mut self) {
        self.slots.rewind();
    }

    /// Paints a prepared picture.
    pub fn paint(&self, index: usize, pass: &mut wgpu::RenderPass<'_>) {
        if let Some(slot) = self.slots.get(index) {
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, &slot.group, &[]);
            pass.draw(0..3, 0..1);
        }
    }
}

/// The resources of a picture with so many rows of data.
fn slot(device: &wgpu::Device, layout: &wgpu::BindGroupLayout, rows: u32) -> Slot {
    let uniforms = gpu::uniforms(device, "field", size_of::<Uniforms>());
    let texture = gpu::Texture {
        label: "field",
        // Some room, for an obstacle more.
        size: [WIDTH as u32, rows.next_power_of_two().max(4)],
        format: wgpu::TextureFormat::Rgba32Float,
        samples: 1,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
    }
    .create(device);
    let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
    let group = gpu::group(
        device,
        layout,
        &[
            uniforms.as_entire_binding(),
            wgpu::BindingResource::TextureView(&view),
        ],
    );
    Slot {
        uniforms,
        texture,
        group,
    }
}
