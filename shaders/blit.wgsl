// Copies a picture into the window, pixel by pixel.

struct View {
    // The picture's upper left corner in the target, in pixels.
    corner: vec2f,
    // Pixels of the picture in one of the target.
    scale: vec2f,
    // 1 where the target turns linear light into sRGB, else 0.
    encodes: f32,
    unused_0: f32,
    unused_1: f32,
    unused_2: f32,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var picture: texture_2d<f32>;

@vertex
fn vs_blit(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u));
    return vec4f(4.0 * corner - 1.0, 0.0, 1.0);
}

fn encoded(colour: vec3f) -> vec3f {
    let low = 12.92 * colour;
    let high = 1.055 * pow(colour, vec3f(1.0 / 2.4)) - 0.055;
    return select(high, low, colour <= vec3f(0.0031308));
}

@fragment
fn fs_blit(@builtin(position) pixel: vec4f) -> @location(0) vec4f {
    let most = vec2i(textureDimensions(picture)) - 1;
    let place = vec2i(floor((pixel.xy - view.corner) * view.scale));
    // Linear: the picture is stored as sRGB and read back as light.
    let colour = textureLoad(picture, clamp(place, vec2i(0), most), 0).rgb;
    return vec4f(select(encoded(colour), colour, view.encodes > 0.5), 1.0);
}
