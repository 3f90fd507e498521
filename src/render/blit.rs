//! Brings a finished picture into the window, pixel by pixel.

use super::gpu;
use bytemuck::{Pod, Zeroable};
use eframe::wgpu;

/// As in the shader.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Uniforms {
    corner: [f32; 2],
    scale: [f32; 2],
    encodes: f32,
    unused: [f32; 3],
}

/// The pipeline.
pub struct Blit {
    pipeline: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
    format: wgpu::TextureFormat,
}

/// A picture and where it goes.
pub struct Placed {
    uniforms: wgpu::Buffer,
    group: wgpu::BindGroup,
}

impl Blit {
    /// A pipeline into single-sampled targets of a format, without depth.
    pub fn new(device: &wgpu::Device, format: wgpu::TextureFormat) -> Self {
        let module = gpu::shader(device, "blit", include_str!("../../shaders/blit.wgsl"));
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("blit"),
            entries: &[
                gpu::uniforms_entry(0),
                gpu::texture_entry(1, wgpu::TextureSampleType::Float { filterable: false }),
            ],
        });
        let pipeline = gpu::Pipeline {
            label: "blit",
            module: &module,
            layout: &layout,
            vertex: "vs_blit",
            buffers: &[],
            fragment: Some(("fs_blit", format, None)),
            depth: None,
            cull: None,
            samples: 1,
        };
        Self {
            pipeline: pipeline.create(device),
            layout,
            format,
        }
    }

    /// What a picture needs to be painted.
    pub fn placed(&self, device: &wgpu::Device, picture: &wgpu::TextureView) -> Placed {
        let uniforms = gpu::uniforms(device, "blit", size_of::<Uniforms>());
        let resources = [
            uniforms.as_entire_binding(),
            wgpu::BindingResource::TextureView(picture),
        ];
        Placed {
            group: gpu::group(device, &self.layout, &resources),
            uniforms,
        }
    }

    /// Says where a picture of so many `pixels` goes: its upper left corner
    /// and its size in the target.
    pub fn place(
        &self,
        queue: &wgpu::Queue,
        placed: &Placed,
        corner: [f32; 2],
        size: [f32; 2],
        pixels: [u32; 2],
    ) {
        let scale = |axis: usize| pixels[axis] as f32 / size[axis].round().max(1.0);
        let uniforms = Uniforms {
            corner: corner.map(f32::round),
            scale: [scale(0), scale(1)],
            encodes: if self.format.is_srgb() { 1.0 } else { 0.0 },
            unused: [0.0; 3],
        };
        queue.write_buffer(&placed.uniforms, 0, bytemuck::bytes_of(&uniforms));
    }

    /// Paints a picture.
    pub fn paint(&self, placed: &Placed, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &placed.group, &[]);
        pass.draw(0..3, 0..1);
    }
}
