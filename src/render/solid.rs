//! The pass that draws the robot in space, with shadows, into a picture of its
//! own; [`super::blit`] brings that into the window.

use super::blit::Blit;
use super::camera::Camera;
use super::gpu;
use super::mesh::{Mesh, Vertex};
use super::slots::Slots;
use super::targets::{self, Geometry, Targets};
use crate::view::{Colour, Theme, one_two_five};
use bytemuck::{Pod, Zeroable};
use eframe::wgpu;
use nalgebra::{Matrix4, Vector3};
use std::sync::Arc;

/// Pixels along each side of the shadow map.
const SHADOWS: u32 = 1536;
/// The direction towards the key light: from the upper left, in front.
const KEY: Vector3<f64> = Vector3::new(-0.42, 0.62, 0.66);
/// How far the shadow map reaches, over the diagonal of what is looked at: half
/// of it and a tenth more, for shadows that fall beside it.
const SHADED: f64 = 0.55;
/// What the diagonal is at least, over the robot's length, so that a map is never
/// divided by nothing.
const LEAST: f64 = 1e-6;
/// How far the board reaches, over the size of what stands before it.
const BOARD: f64 = 1.3;

/// A picture of the robot in space as plain data.
#[derive(Clone, Debug)]
pub struct SolidPicture {
    /// What there is.
    pub mesh: Arc<Mesh>,
    /// From where it is seen.
    pub camera: Camera,
    /// In what light.
    pub theme: Theme,
}

/// As in the shader.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Uniforms {
    clip: [[f32; 4]; 4],
    light: [[f32; 4]; 4],
    eye: [f32; 4],
    right: [f32; 4],
    up: [f32; 4],
    key: [f32; 4],
    sky: [f32; 4],
    ground: [f32; 4],
    background: [f32; 4],
    grid: [f32; 4],
    board: [f32; 4],
    lines: [f32; 4],
}

impl SolidPicture {
    fn uniforms(&self, aspect: f64) -> Uniforms {
        let (mesh, camera) = (&*self.mesh, &self.camera);
        let matrix = |m: Matrix4<f64>| m.cast::<f32>().into();
        let [right, up, _] = camera.axes();
        let four = |v: Vector3<f64>, w: f64| [v.x as f32, v.y as f32, v.z as f32, w as f32];
        let palette = self.theme.palette();
        let light = |colour: Colour| Vector3::from(colour.rgb.map(linear));
        let (sky, ground, shadow, glow, covers, lines) = match self.theme {
            Theme::Light => (0.50, 0.30, 0.30, 0.80, 0.75, 0.22),
            Theme::Dark => (0.52, 0.20, 0.60, 0.40, 0.15, 0.10),
        };
        let focus = mesh.focus.centre() - mesh.origin;
        let size = mesh.focus.size().norm();
        let spacing = one_two_five(mesh.length / 15.0);
        // The grid's lines lie on round coordinates of the world.
        let offset = mesh.origin.map(|x| -x.rem_euclid(5.0 * spacing));
        Uniforms {
            clip: matrix(camera.clip(mesh.origin, aspect)),
            light: matrix(light_matrix(mesh)),
            eye: four(camera.eye() - mesh.origin, 1.0),
            right: four(right, 0.0),
            up: four(up, 0.0),
            key: four(KEY.normalize(), shadow),
            sky: four(sky * Vector3::new(0.96, 0.99, 1.06), covers),
            ground: four(ground * Vector3::new(1.04, 1.0, 0.95), 0.0),
            background: four(light(palette.background), glow),
            grid: four(light(palette.quiet), lines),
            board: four(
                Vector3::new(focus.x, focus.y, mesh.board - mesh.origin.z),
                BOARD * size,
            ),
            lines: four(
                Vector3::new(offset.x, offset.y, spacing),
                1.0 / f64::from(SHADOWS),
            ),
        }
    }
}

/// From the world to the key light's shadow map: x and y from −1 to 1 and
/// depth from 0 to 1 hold the solids and what they shade of the board.
fn light_matrix(mesh: &Mesh) -> Matrix4<f64> {
    let middle = mesh.focus.centre() - mesh.origin;
    let reach = SHADED * mesh.focus.size().norm().max(LEAST * mesh.length);
    let back = KEY.normalize();
    let right = Vector3::y().cross(&back).normalize();
    let up = back.cross(&right);
    let row = |axis: Vector3<f64>, scale: f64, shift: f64| {
        let axis = axis / scale;
        [axis.x, axis.y, axis.z, shift - axis.dot(&middle)]
    };
    let rows = [
        row(right, reach, 0.0),
        row(up, reach, 0.0),
        row(-back, 4.0 * reach, 0.5),
        [0.0, 0.0, 0.0, 1.0],
    ];
    Matrix4::from_fn(|i, j| rows[i][j])
}

fn linear(part: u8) -> f64 {
    let part = f64::from(part) / 255.0;
    if part <= 0.04045 {
        part / 12.92
    } else {
        ((part + 0.055) / 1.055).powf(2.4)
    }
}

/// The pass: its pipelines, and the resources of each picture.
pub struct SolidPass {
    shadow: wgpu::RenderPipeline,
    backdrop: wgpu::RenderPipeline,
    solid: wgpu::RenderPipeline,
    board: wgpu::RenderPipeline,
    glow: wgpu::RenderPipeline,
    overlay: wgpu::RenderPipeline,
    casting: wgpu::BindGroupLayout,
    seeing: wgpu::BindGroupLayout,
    sampler: wgpu::Sampler,
    samples: u32,
    blit: Blit,
    slots: Slots<Slot>,
}

/// The resources of one picture.
struct Slot {
    mesh: Option<Arc<Mesh>>,
    solids: Geometry,
    overlay: Geometry,
    glows: Geometry,
    uniforms: wgpu::Buffer,
    casting: wgpu::BindGroup,
    seeing: wgpu::BindGroup,
    shadows: wgpu::TextureView,
    targets: Option<Targets>,
}

impl SolidPass {
    /// A pass whose pictures are painted into single-sampled targets of a
    /// format, without depth. `samples`: 4, or 1 where the adapter can't.
    pub fn new(device: &wgpu::Device, format: wgpu::TextureFormat, samples: u32) -> Self {
        let module = gpu::shader(device, "solid", include_str!("../../shaders/solid.wgsl"));
        let layout = |entries: &[wgpu::BindGroupLayoutEntry]| {
            device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: Some("solid"),
                entries,
            })
        };
        let casting = layout(&[gpu::uniforms_entry(0)]);
        let seeing = layout(&[
            gpu::uniforms_entry(0),
            gpu::texture_entry(1, wgpu::TextureSampleType::Depth),
            gpu::sampler_entry(2, wgpu::SamplerBindingType::Comparison),
        ]);
        let corners = [Some(wgpu::VertexBufferLayout {
            array_stride: size_of::<Vertex>() as u64,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &wgpu::vertex_attr_array![
                0 => Float32x3, 1 => Float32x3, 2 => Unorm8x4, 3 => Unorm8x4
            ],
        })];
        let over = wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING;
        let pipeline = |vertex, fragment, blend, buffers, depth| {
            gpu::Pipeline {
                label: vertex,
                module: &module,
                layout: &seeing,
                vertex,
                buffers,
                fragment: Some((fragment, targets::COLOUR, blend)),
                depth: Some(depth),
                cull: None,
                samples,
            }
            .create(device)
        };
        let (front, behind) = (depth(Depth::Written), depth(Depth::Read));
        Self {
            shadow: gpu::Pipeline {
                label: "shadow",
                module: &module,
                layout: &casting,
                vertex: "vs_shadow",
                buffers: &corners,
                fragment: None,
                depth: Some(wgpu::DepthStencilState {
                    bias: wgpu::DepthBiasState {
                        constant: 0,
                        slope_scale: 2.0,
                        clamp: 0.0,
                    },
                    ..depth(Depth::Written)
                }),
                cull: None,
                samples: 1,
            }
            .create(device),
            backdrop: pipeline(
                "vs_backdrop",
                "fs_backdrop",
                None,
                &[],
                depth(Depth::Unread),
            ),
            solid: pipeline("vs_solid", "fs_solid", None, &corners, front.clone()),
            board: gpu::Pipeline {
                label: "board",
                module: &module,
                layout: &seeing,
                vertex: "vs_board",
                buffers: &[],
                fragment: Some(("fs_board", targets::COLOUR, Some(over))),
                depth: Some(behind.clone()),
                // From behind one looks through the board.
                cull: Some(wgpu::Face::Back),
                samples,
            }
            .create(device),
            glow: pipeline(
                "vs_glow",
                "fs_glow",
                Some(over),
                &corners,
                depth(Depth::Unread),
            ),
            overlay: pipeline("vs_overlay", "fs_overlay", None, &corners, front),
            sampler: device.create_sampler(&wgpu::SamplerDescriptor {
                label: Some("shadows"),
                mag_filter: wgpu::FilterMode::Linear,
                min_filter: wgpu::FilterMode::Linear,
                compare: Some(wgpu::CompareFunction::LessEqual),
                ..wgpu::SamplerDescriptor::default()
            }),
            casting,
            seeing,
            samples,
            blit: Blit::new(device, format),
            slots: Slots::new(),
        }
    }

    /// Draws a picture into its own target and gives the index to paint it by.
    /// `corner`: where its upper left corner will be in the window, and
    /// `size`, both in pixels.
    pub fn prepare(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        picture: &SolidPicture,
        [corner, size]: [[f32; 2]; 2],
    ) -> usize {
        let most = device.limits().max_texture_dimension_2d;
        let pixels = size.map(|side| (side.round() as u32).clamp(1, most));
        let (casting, seeing, sampler) = (&self.casting, &self.seeing, &self.sampler);
        let make = || slot(device, casting, seeing, sampler);
        let (index, slot) = self.slots.next(make);
        let targets = match slot.targets.take() {
            Some(targets) if targets.size == pixels => targets,
            _ => Targets::new(device, pixels, self.samples, &self.blit),
        };
        self.blit.place(queue, &targets.blit, corner, size, pixels);
        let aspect = f64::from(pixels[0]) / f64::from(pixels[1]);
        let uniforms = picture.uniforms(aspect);
        queue.write_buffer(&slot.uniforms, 0, bytemuck::bytes_of(&uniforms));
        let sent = slot.mesh.as_ref();
        if !sent.is_some_and(|sent| Arc::ptr_eq(sent, &picture.mesh)) {
            let mesh = &picture.mesh;
            slot.solids
                .send(device, queue, &mesh.solids.vertices, &mesh.solids.indices);
            slot.overlay
                .send(device, queue, &mesh.overlay.vertices, &mesh.overlay.indices);
            slot.glows.send(device, queue, &mesh.glows, &[]);
            slot.mesh = Some(Arc::clone(mesh));
            // The light stands still, so shadows change with the mesh alone.
            let mut pass = targets::depth_pass(encoder, &slot.shadows);
            pass.set_pipeline(&self.shadow);
            pass.set_bind_group(0, &slot.casting, &[]);
            slot.solids.draw(&mut pass);
        }
        let mut pass = targets.pass(encoder);
        pass.set_bind_group(0, &slot.seeing, &[]);
        pass.set_pipeline(&self.backdrop);
        pass.draw(0..3, 0..1);
        pass.set_pipeline(&self.solid);
        slot.solids.draw(&mut pass);
        pass.set_pipeline(&self.board);
        pass.draw(0..6, 0..1);
        pass.set_pipeline(&self.glow);
        slot.glows.draw(&mut pass);
        pass.set_pipeline(&self.overlay);
        slot.overlay.draw(&mut pass);
        drop(pass);
        slot.targets = Some(targets);
        index
    }

    /// To be called when all pictures of a frame are prepared.
    pub fn prepared(&mut self) {
        self.slots.rewind();
    }

    /// Paints a prepared picture.
    pub fn paint(&self, index: usize, pass: &mut wgpu::RenderPass<'_>) {
        if let Some(targets) = self.slots.get(index).and_then(|slot| slot.targets.as_ref()) {
            self.blit.paint(&targets.blit, pass);
        }
    }
}

/// What a pipeline does with depth.
#[derive(Clone, Copy)]
enum Depth {
    Written,
    Read,
    Unread,
}

fn depth(depth: Depth) -> wgpu::DepthStencilState {
    wgpu::DepthStencilState {
        format: targets::DEPTH,
        depth_write_enabled: Some(matches!(depth, Depth::Written)),
        depth_compare: Some(match depth {
            Depth::Unread => wgpu::CompareFunction::Always,
            _ => wgpu::CompareFunction::LessEqual,
        }),
        stencil: wgpu::StencilState::default(),
        bias: wgpu::DepthBiasState::default(),
    }
}

fn slot(
    device: &wgpu::Device,
    casting: &wgpu::BindGroupLayout,
    seeing: &wgpu::BindGroupLayout,
    sampler: &wgpu::Sampler,
) -> Slot {
    let uniforms = gpu::uniforms(device, "solid", size_of::<Uniforms>());
    let shadows = gpu::Texture {
        label: "shadows",
        size: [SHADOWS; 2],
        format: targets::DEPTH,
        samples: 1,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING,
    }
    .create(device)
    .create_view(&wgpu::TextureViewDescriptor::default());
    let whole = uniforms.as_entire_binding();
    Slot {
        mesh: None,
        solids: Geometry::default(),
        overlay: Geometry::default(),
        glows: Geometry::default(),
        casting: gpu::group(device, casting, std::slice::from_ref(&whole)),
        seeing: gpu::group(
            device,
            seeing,
            &[
                whole,
                wgpu::BindingResource::TextureView(&shadows),
                wgpu::BindingResource::Sampler(sampler),
            ],
        ),
        uniforms,
        shadows,
        targets: None,
    }
}
