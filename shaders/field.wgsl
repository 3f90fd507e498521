// The clearance f(x) of the nearest obstacle as a quiet tint with contour
// lines. All lengths are in metres, relative to the middle of the window.

struct View {
    // The middle of the window, in pixels of the target.
    middle: vec2f,
    // Half of what the window shows.
    half_size: vec2f,
    // One pixel.
    pixel: f32,
    // Between neighbouring contour lines.
    spacing: f32,
    // How far the tint and the lines reach.
    reach: f32,
    // Every how many lines one is stronger.
    stronger: f32,
    // Colours in sRGB with opacity: the tint at a surface, the lines, the
    // surface.
    tint: vec4f,
    line: vec4f,
    surface: vec4f,
    // 1 where the target turns linear light into sRGB, else 0.
    encodes: f32,
    unused_0: f32,
    unused_1: f32,
    unused_2: f32,
}

@group(0) @binding(0) var<uniform> view: View;
// See cells.rs for what is where.
@group(0) @binding(1) var data: texture_2d<f32>;

// Columns of the data, and cells along each side of the window: as in cells.rs.
const WIDTH: i32 = 1024;
const CELLS: i32 = 32;
const FAR: f32 = 1e30;

const ARC: i32 = 0;
const POINT: i32 = 1;

fn texel(index: i32) -> vec4f {
    return textureLoad(data, vec2i(index % WIDTH, index / WIDTH), 0);
}

// A disc or wall that is far or large: its clearance at the middle, its normal
// there and the curvature of its level line there. Loses no digits.
fn arc_clearance(at: vec4f, p: vec2f) -> f32 {
    let along = dot(at.xy, p);
    let rise = 2.0 * along + at.w * dot(p, p);
    return at.z + rise / (1.0 + sqrt(max(1.0 + at.w * rise, 0.0)));
}

// A convex polygon or, of two vertices, a segment, grown by a radius.
fn polygon_clearance(first: i32, count: i32, radius: f32, p: vec2f) -> f32 {
    var highest = -FAR;
    var inside = -FAR;
    var outside = FAR;
    for (var i = 0; i < count; i++) {
        let corner = texel(first + 2 * i);
        let edge = texel(first + 2 * i + 1);
        let away = p - corner.xy;
        let rise = dot(corner.zw, p);
        let height = edge.x + rise;
        let along = corner.z * away.y - corner.w * away.x;
        outside = min(outside, length(away) - radius);
        if (height >= 0.0 || count == 2) && along > 0.0 && along < edge.y {
            outside = min(outside, select(-height - radius, edge.z + rise, height >= 0.0));
        }
        if height > highest {
            highest = height;
            inside = edge.z + rise;
        }
    }
    if highest <= 0.0 && count > 2 {
        return inside;
    }
    return outside;
}

fn clearance(p: vec2f) -> f32 {
    let share = 0.5 + 0.5 * p / view.half_size;
    let cell = clamp(vec2i(floor(share * f32(CELLS))), vec2i(0), vec2i(CELLS - 1));
    let list = texel(cell.y * CELLS + cell.x);
    var least = FAR;
    for (var i = 0; i < i32(list.y); i++) {
        let entry = texel(i32(list.x) + i);
        let first = i32(entry.x);
        let kind = i32(entry.w);
        if kind == ARC {
            least = min(least, arc_clearance(texel(first), p));
        } else if kind == POINT {
            least = min(least, length(p - texel(first).xy) - entry.z);
        } else {
            least = min(least, polygon_clearance(first, i32(entry.y), entry.z, p));
        }
    }
    return least;
}

// The point of the world at a pixel of the target.
fn place(pixel: vec4f) -> vec2f {
    let away = (pixel.xy - view.middle) * view.pixel;
    return vec2f(away.x, -away.y);
}

@vertex
fn vs_field(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u));
    return vec4f(4.0 * corner - 1.0, 0.0, 1.0);
}

// How much of a pixel a line covers whose middle is so far away, in pixels.
fn coverage(distance: f32, width: f32) -> f32 {
    return clamp(0.5 * width + 0.5 - distance, 0.0, min(width, 1.0));
}

fn over(top: vec4f, below: vec4f) -> vec4f {
    return top + below * (1.0 - top.a);
}

fn paint(colour: vec4f, opacity: f32) -> vec4f {
    let alpha = colour.a * opacity;
    return vec4f(colour.rgb * alpha, alpha);
}

fn linear(colour: vec3f) -> vec3f {
    let low = colour / 12.92;
    let high = pow((colour + 0.055) / 1.055, vec3f(2.4));
    return select(high, low, colour <= vec3f(0.04045));
}

@fragment
fn fs_field(@builtin(position) pixel: vec4f) -> @location(0) vec4f {
    let f = clearance(place(pixel));
    if f >= FAR {
        return vec4f(0.0);
    }
    // The field is a distance, so its slope is one everywhere: no derivatives.
    let beyond = max(f, 0.0);
    let fading = exp(-beyond / view.reach);
    let step = round(f / view.spacing);
    let off_line = abs(f - step * view.spacing) / view.pixel;
    let strong = abs(step - view.stronger * round(step / view.stronger)) < 0.5;
    var colour = paint(view.tint, fading);
    if step > 0.5 {
        let opacity = select(0.5, 1.0, strong) * sqrt(fading);
        colour = over(paint(view.line, opacity * coverage(off_line, 1.0)), colour);
    }
    colour = over(paint(view.surface, coverage(abs(f) / view.pixel, 1.5)), colour);
    if view.encodes > 0.5 && colour.a > 0.0 {
        colour = vec4f(linear(colour.rgb / colour.a) * colour.a, colour.a);
    }
    return colour;
}

// The clearance itself, for whoever wants numbers.
@fragment
fn fs_clearance(@builtin(position) pixel: vec4f) -> @location(0) vec4f {
    return vec4f(clearance(place(pixel)), 0.0, 0.0, 1.0);
}
