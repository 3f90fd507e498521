//! What a picture in space is drawn into and from: colour and depth, and
//! buffers of corners and indices.

use super::blit::{Blit, Placed};
use super::gpu;
use super::mesh::Vertex;
use eframe::wgpu;

/// The format of a picture's colour: eight bits that are read as light.
pub const COLOUR: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8UnormSrgb;
/// The format of depth, of pictures and of shadows.
pub const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// Colour and depth of one picture.
pub struct Targets {
    /// In pixels.
    pub size: [u32; 2],
    /// The colour, ready to be painted.
    pub blit: Placed,
    colour: wgpu::TextureView,
    /// What is resolved into the colour; none where it is drawn directly.
    samples: Option<wgpu::TextureView>,
    depth: wgpu::TextureView,
}

impl Targets {
    /// Targets of a size in pixels with so many samples each.
    pub fn new(device: &wgpu::Device, size: [u32; 2], samples: u32, blit: &Blit) -> Self {
        let attachment = wgpu::TextureUsages::RENDER_ATTACHMENT;
        let view = |format, samples, usage| {
            let texture = gpu::Texture {
                label: "solid",
                size,
                format,
                samples,
                usage,
            };
            let texture = texture.create(device);
            texture.create_view(&wgpu::TextureViewDescriptor::default())
        };
        let colour = view(COLOUR, 1, attachment | wgpu::TextureUsages::TEXTURE_BINDING);
        Self {
            size,
            blit: blit.placed(device, &colour),
            samples: (samples > 1).then(|| view(COLOUR, samples, attachment)),
            depth: view(DEPTH, samples, attachment),
            colour,
        }
    }

    /// A pass that draws anew.
    pub fn pass<'a>(&self, encoder: &'a mut wgpu::CommandEncoder) -> wgpu::RenderPass<'a> {
        let (view, resolve_target, store) = match &self.samples {
            Some(samples) => (samples, Some(&self.colour), wgpu::StoreOp::Discard),
            None => (&self.colour, None, wgpu::StoreOp::Store),
        };
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("solid"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view,
                depth_slice: None,
                resolve_target,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::BLACK),
                    store,
                },
            })],
            depth_stencil_attachment: Some(cleared(&self.depth, wgpu::StoreOp::Discard)),
            timestamp_writes: None,
            occlusion_query_set: None,
            multiview_mask: None,
        })
    }
}

/// A pass that draws depth alone, anew.
pub fn depth_pass<'a>(
    encoder: &'a mut wgpu::CommandEncoder,
    view: &wgpu::TextureView,
) -> wgpu::RenderPass<'a> {
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("shadows"),
        color_attachments: &[],
        depth_stencil_attachment: Some(cleared(view, wgpu::StoreOp::Store)),
        timestamp_writes: None,
        occlusion_query_set: None,
        multiview_mask: None,
    })
}

fn cleared(
    view: &wgpu::TextureView,
    store: wgpu::StoreOp,
) -> wgpu::RenderPassDepthStencilAttachment<'_> {
    wgpu::RenderPassDepthStencilAttachment {
        view,
        depth_ops: Some(wgpu::Operations {
            load: wgpu::LoadOp::Clear(1.0),
            store,
        }),
        stencil_ops: None,
    }
}

/// Corners and indices on the device, which keep their storage while there is
/// room.
#[derive(Default)]
pub struct Geometry {
    corners: Option<wgpu::Buffer>,
    indices: Option<wgpu::Buffer>,
    /// Of indices or, where there are none, of corners.
    count: u32,
}

impl Geometry {
    /// Sends corners and the indices by which they make triangles; without
    /// indices they make them in order.
    pub fn send(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        corners: &[Vertex],
        indices: &[u32],
    ) {
        let (vertex, index) = (wgpu::BufferUsages::VERTEX, wgpu::BufferUsages::INDEX);
        fill(
            device,
            queue,
            &mut self.corners,
            bytemuck::cast_slice(corners),
            vertex,
        );
        if indices.is_empty() {
            self.indices = None;
            self.count = corners.len() as u32;
        } else {
            fill(
                device,
                queue,
                &mut self.indices,
                bytemuck::cast_slice(indices),
                index,
            );
            self.count = indices.len() as u32;
        }
    }

    /// Draws the triangles, if any.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        let Some(corners) = self.corners.as_ref().filter(|_| self.count > 0) else {
            return;
        };
        pass.set_vertex_buffer(0, corners.slice(..));
        match &self.indices {
            Some(indices) => {
                pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint32);
                pass.draw_indexed(0..self.count, 0, 0..1);
            }
            None => pass.draw(0..self.count, 0..1),
        }
    }
}

/// Writes bytes, a multiple of four, into a buffer that has room for them.
fn fill(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    buffer: &mut Option<wgpu::Buffer>,
    bytes: &[u8],
    usage: wgpu::BufferUsages,
) {
    let needed = bytes.len() as u64;
    let room = |buffer: &wgpu::Buffer| buffer.size() >= needed;
    let buffer = match buffer.take().filter(room) {
        Some(kept) => buffer.insert(kept),
        None => buffer.insert(device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("solid"),
            size: needed.next_power_of_two().max(1024),
            usage: usage | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        })),
    };
    if needed > 0 {
        queue.write_buffer(buffer, 0, bytes);
    }
}
