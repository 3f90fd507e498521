//! Renders into textures on a software adapter, and reads them back.

use std::sync::Arc;

use eframe::egui_wgpu::{RendererOptions, WgpuSetup};
use eframe::wgpu;
use egui_kittest::wgpu::{create_render_state, default_wgpu_setup};

/// A device to render on, the one of the window's own tests.
pub struct Offscreen {
    pub device: wgpu::Device,
    pub queue: wgpu::Queue,
}

/// Pixels, row by row from the top.
pub struct Picture<T> {
    width: u32,
    values: Vec<T>,
}

impl<T: Copy> Picture<T> {
    pub fn at(&self, x: u32, y: u32) -> T {
        self.values[(y * self.width + x) as usize]
    }

    pub fn pixels(&self) -> impl Iterator<Item = (u32, u32, T)> + '_ {
        let numbered = (0..).zip(&self.values);
        numbered.map(|(i, value)| (i % self.width, i / self.width, *value))
    }
}

impl Picture<[u8; 4]> {
    /// Writes the picture into the folder that `PICTURES` names, if any.
    pub fn save(&self, name: &str) {
        if let Some(folder) = std::env::var_os("PICTURES") {
            let path = std::path::Path::new(&folder).join(format!("{name}.png"));
            let height = self.values.len() as u32 / self.width;
            let bytes = self.values.concat();
            let image = image::RgbaImage::from_raw(self.width, height, bytes).unwrap();
            image.save(path).unwrap();
        }
    }
}

impl Offscreen {
    pub fn new() -> Self {
        Self::of(default_wgpu_setup())
    }

    /// A device that offers no more than some limits; what goes beyond them
    /// panics.
    pub fn within(limits: wgpu::Limits) -> Self {
        let mut setup = default_wgpu_setup();
        if let WgpuSetup::CreateNew(setup) = &mut setup {
            setup.device_descriptor = Arc::new(move |_| wgpu::DeviceDescriptor {
                required_limits: limits.clone(),
                ..wgpu::DeviceDescriptor::default()
            });
        }
        Self::of(setup)
    }

    fn of(setup: WgpuSetup) -> Self {
        let state = create_render_state(setup, RendererOptions::PREDICTABLE);
        Self {
            device: state.device.clone(),
            queue: state.queue.clone(),
        }
    }

    /// What is painted into a target of a format of eight bits a channel, as
    /// it is stored.
    pub fn image(
        &self,
        format: wgpu::TextureFormat,
        [width, height]: [u32; 2],
        background: [u8; 4],
        paint: impl FnOnce(&mut wgpu::RenderPass<'_>),
    ) -> Picture<[u8; 4]> {
        let bytes = self.painted([width, height], format, background, paint);
        Picture {
            width,
            values: bytes
                .chunks_exact(4)
                .map(|p| [p[0], p[1], p[2], p[3]])
                .collect(),
        }
    }

    /// What is painted into the red channel of a target of floats.
    pub fn floats(
        &self,
        width: u32,
        height: u32,
        paint: impl FnOnce(&mut wgpu::RenderPass<'_>),
    ) -> Picture<f32> {
        let format = wgpu::TextureFormat::R32Float;
        let bytes = self.painted([width, height], format, [0; 4], paint);
        let float = |p: &[u8]| f32::from_le_bytes([p[0], p[1], p[2], p[3]]);
        Picture {
            width,
            values: bytes.chunks_exact(4).map(float).collect(),
        }
    }

    /// The bytes of a target with four of them a pixel.
    fn painted(
        &self,
        [width, height]: [u32; 2],
        format: wgpu::TextureFormat,
        background: [u8; 4],
        paint: impl FnOnce(&mut wgpu::RenderPass<'_>),
    ) -> Vec<u8> {
        let size = wgpu::Extent3d {
            width,
            height,
            depth_or_array_layers: 1,
        };
        let texture = self.device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size,
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let mut encoder = self.device.create_command_encoder(&Default::default());
        let [r, g, b, a] = background.map(|part| f64::from(part) / 255.0);
        {
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: None,
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: &view,
                    depth_slice: None,
                    resolve_target: None,
                    ops: wgpu::Operations {
                        load: wgpu::LoadOp::Clear(wgpu::Color { r, g, b, a }),
                        store: wgpu::StoreOp::Store,
                    },
                })],
                depth_stencil_attachment: None,
                timestamp_writes: None,
                occlusion_query_set: None,
                multiview_mask: None,
            });
            paint(&mut pass);
        }
        let row = (4 * width).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let buffer = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: u64::from(row * height),
            usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let target = wgpu::TexelCopyBufferInfo {
            buffer: &buffer,
            layout: wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(row),
                rows_per_image: None,
            },
        };
        encoder.copy_texture_to_buffer(texture.as_image_copy(), target, size);
        self.queue.submit([encoder.finish()]);
        buffer
            .slice(..)
            .map_async(wgpu::MapMode::Read, |mapped| mapped.unwrap());
        self.device
            .poll(wgpu::PollType::wait_indefinitely())
            .unwrap();
        let mapped = buffer.slice(..).get_mapped_range().unwrap();
        let rows = mapped.chunks_exact(row as usize);
        rows.flat_map(|r| r[..4 * width as usize].to_vec())
            .collect()
    }
}
