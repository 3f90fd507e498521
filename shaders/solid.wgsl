// The robot in space: lit solids, the board behind them, glows, and the key
// light's shadows. Colours come in as sRGB and leave as linear light.
//
// Positions are in metres from the mesh's origin; the board is parallel to the
// plane of the robot and y is up.

struct View {
    // From the world to clip space, and to the shadow map.
    clip: mat4x4f,
    light: mat4x4f,
    // The camera, and its directions to the right and up.
    eye: vec4f,
    right: vec4f,
    up: vec4f,
    // Towards the key light; w: how dark its shadows are on the board.
    key: vec4f,
    // Light from above and from below, linear; w of the sky's: how much a glow
    // covers what it lies over.
    sky: vec4f,
    ground: vec4f,
    // The background, linear; w: how strong glows are.
    background: vec4f,
    // The grid's colour, linear, and its opacity.
    grid: vec4f,
    // The board: its middle, its z and how far it reaches.
    board: vec4f,
    // The grid: its offset, its spacing; w: one texel of the shadow map.
    lines: vec4f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var shadows: texture_depth_2d;
@group(0) @binding(2) var shadow_sampler: sampler_comparison;

fn linear(colour: vec3f) -> vec3f {
    let low = colour / 12.92;
    let high = pow((colour + 0.055) / 1.055, vec3f(2.4));
    return select(high, low, colour <= vec3f(0.04045));
}

// Bright light saturates softly instead of clipping.
fn toned(light: vec3f) -> vec3f {
    let knee = vec3f(0.7);
    let above = max(light - knee, vec3f(0.0));
    return min(light, knee) + 0.3 * (1.0 - exp(-above / 0.3));
}

// --- Solids ---

struct Corner {
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) colour: vec4f,
    // Emission, gloss, metal, openness.
    @location(3) finish: vec4f,
}

struct Surface {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) colour: vec3f,
    @location(3) finish: vec4f,
}

fn surface(corner: Corner) -> Surface {
    var out: Surface;
    out.clip = view.clip * vec4f(corner.position, 1.0);
    out.position = corner.position;
    out.normal = corner.normal;
    out.colour = linear(corner.colour.rgb);
    out.finish = corner.finish;
    return out;
}

@vertex
fn vs_solid(corner: Corner) -> Surface {
    var out = surface(corner);
    // The nearest tenth of the depth belongs to the overlay.
    out.clip.z = 0.1 * out.clip.w + 0.9 * out.clip.z;
    return out;
}

@vertex
fn vs_overlay(corner: Corner) -> Surface {
    var out = surface(corner);
    out.clip.z = 0.1 * out.clip.z;
    return out;
}

@vertex
fn vs_shadow(corner: Corner) -> @builtin(position) vec4f {
    return view.light * vec4f(corner.position, 1.0);
}

// How much of the key light reaches a place, from 0 to 1.
fn lit(position: vec3f, normal: vec3f) -> f32 {
    let texel = view.lines.w;
    // Off the surface by more than the filter's width, so that nothing
    // shadows itself.
    let place = view.light * vec4f(position, 1.0);
    let uv = vec2f(0.5 + 0.5 * place.x, 0.5 - 0.5 * place.y);
    if any(uv < vec2f(0.0)) || any(uv > vec2f(1.0)) || place.z > 1.0 {
        return 1.0;
    }
    let depth = place.z - 0.0012;
    var light = 0.0;
    for (var y = -2; y <= 2; y++) {
        for (var x = -2; x <= 2; x++) {
            let at = uv + 1.6 * texel * vec2f(f32(x), f32(y));
            light += textureSampleCompareLevel(shadows, shadow_sampler, at, depth);
        }
    }
    return light / 25.0;
}

// A studio: dark below, bright above, one large soft box at the key light and
// a narrow one behind to the right.
fn studio(direction: vec3f) -> vec3f {
    let up = smoothstep(-0.35, 0.75, direction.y);
    var light = mix(view.ground.rgb, view.sky.rgb, up);
    light += 1.6 * smoothstep(0.72, 0.93, dot(direction, view.key.xyz));
    light += 0.7 * smoothstep(0.80, 0.95, dot(direction, normalize(vec3f(0.85, 0.25, -0.2))));
    return light;
}

fn shaded(in: Surface) -> vec3f {
    let n = normalize(in.normal);
    let v = normalize(view.eye.xyz - in.position);
    let emission = in.finish.x;
    let gloss = in.finish.y;
    let metal = in.finish.z;
    let open = in.finish.w;
    let facing = max(dot(n, v), 0.0);
    let towards = dot(n, view.key.xyz);
    var shadow = 0.0;
    if towards > 0.0 {
        shadow = lit(in.position, n);
    }
    // Diffuse: sky and ground, the key light, a cool fill from the right.
    let sky = mix(view.ground.rgb, view.sky.rgb, 0.5 + 0.5 * n.y);
    let fill = max(dot(n, normalize(vec3f(0.8, 0.1, 0.45))), 0.0);
    var diffuse = sky * open * (0.85 + 0.15 * n.z);
    diffuse += vec3f(1.0, 0.975, 0.94) * max(towards, 0.0) * shadow * 0.95;
    diffuse += vec3f(0.86, 0.93, 1.0) * fill * 0.16 * open;
    // Specular: the key light's highlight and the studio's reflection.
    let half_way = normalize(view.key.xyz + v);
    let power = exp2(2.0 + 7.0 * gloss);
    let highlight = pow(max(dot(n, half_way), 0.0), power) * (power + 8.0) / 60.0;
    let f0 = mix(vec3f(0.04), max(in.colour, vec3f(0.25)), metal);
    let fresnel = f0 + (1.0 - f0) * pow(1.0 - facing, 5.0) * gloss;
    let mirrored = studio(reflect(-v, n)) * gloss * (0.4 + 0.6 * max(shadow, 0.5));
    let specular = fresnel * (mirrored + gloss * highlight * shadow);
    var colour = in.colour * diffuse * (1.0 - 0.6 * metal) + specular;
    // A glow of its own is brightest where it faces the viewer.
    colour = mix(colour, in.colour * (0.75 + 0.45 * facing), emission);
    return toned(colour);
}

@fragment
fn fs_solid(in: Surface) -> @location(0) vec4f {
    return vec4f(shaded(in), 1.0);
}

// Marks have a dark edge, so that they stand out from whatever is behind.
@fragment
fn fs_overlay(in: Surface) -> @location(0) vec4f {
    let away = normalize(view.eye.xyz - in.position);
    let facing = dot(normalize(in.normal), away);
    let edge = smoothstep(0.20, 0.50, facing);
    return vec4f(shaded(in) * mix(0.16, 1.0, edge), 1.0);
}

// --- What is behind ---

struct Backdrop {
    @builtin(position) clip: vec4f,
    @location(0) place: vec2f,
}

@vertex
fn vs_backdrop(@builtin(vertex_index) index: u32) -> Backdrop {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u));
    var out: Backdrop;
    out.place = 4.0 * corner - 1.0;
    out.clip = vec4f(out.place, 0.0, 1.0);
    return out;
}

// Noise of less than a step of eight bits, against bands in soft shades.
fn dithered(colour: vec3f, pixel: vec2f) -> vec3f {
    let noise = fract(52.9829189 * fract(dot(pixel, vec2f(0.06711056, 0.00583715)))) - 0.5;
    let level = max(dot(colour, vec3f(0.333)), 0.003);
    // A step of sRGB in linear light.
    let step = 1.9 * pow(level, 0.58) / 255.0;
    return max(colour + noise * step, vec3f(0.0));
}

@fragment
fn fs_backdrop(in: Backdrop) -> @location(0) vec4f {
    // A soft pool of light behind the robot.
    let away = length((in.place - vec2f(-0.1, 0.15)) * vec2f(0.7, 0.75));
    let pool = exp(-1.3 * away * away);
    let shade = mix(0.90, 1.0, pool) + view.grid.w * 0.35 * pool * (1.0 - view.background.r);
    return vec4f(dithered(view.background.rgb * shade, in.clip.xy), 1.0);
}

struct Board {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
}

@vertex
fn vs_board(@builtin(vertex_index) index: u32) -> Board {
    var corners = array(
        vec2f(-1.0, -1.0), vec2f(1.0, -1.0), vec2f(1.0, 1.0),
        vec2f(-1.0, -1.0), vec2f(1.0, 1.0), vec2f(-1.0, 1.0),
    );
    let place = view.board.xy + view.board.w * corners[index];
    var out: Board;
    out.position = vec3f(place, view.board.z);
    out.clip = view.clip * vec4f(out.position, 1.0);
    out.clip.z = 0.1 * out.clip.w + 0.9 * out.clip.z;
    return out;
}

// How much of a pixel the lines of a grid cover.
fn grid(place: vec2f, spacing: f32) -> f32 {
    let at = place / spacing;
    let width = max(fwidth(at), vec2f(1e-6));
    let away = abs(fract(at - 0.5) - 0.5) / width;
    // Lines closer than a few pixels fade out.
    let seen = clamp(0.5 / width - 1.0, vec2f(0.0), vec2f(1.0));
    let line = clamp(1.0 - away, vec2f(0.0), vec2f(1.0)) * seen;
    return max(line.x, line.y);
}

@fragment
fn fs_board(in: Board) -> @location(0) vec4f {
    let place = in.position.xy - view.lines.xy;
    let fine = grid(place, view.lines.z);
    let coarse = grid(place, 5.0 * view.lines.z);
    let away = length(in.position.xy - view.board.xy) / view.board.w;
    let fade = 1.0 - smoothstep(0.25, 1.0, away);
    let shade = (1.0 - lit(in.position, vec3f(0.0, 0.0, 1.0))) * view.key.w * fade;
    let line = max(0.5 * fine, coarse) * view.grid.w * fade;
    // Shadow over lines: both darken what is behind.
    let alpha = line + shade - line * shade;
    let colour = view.grid.rgb * line * (1.0 - shade);
    return vec4f(colour, alpha);
}

// --- Glows ---

struct Glow {
    @builtin(position) clip: vec4f,
    @location(0) place: vec2f,
    @location(1) colour: vec4f,
}

@vertex
fn vs_glow(corner: Corner) -> Glow {
    let aside = corner.normal.x * view.right.xyz + corner.normal.y * view.up.xyz;
    var out: Glow;
    out.clip = view.clip * vec4f(corner.position + aside, 1.0);
    out.place = corner.normal.xy / corner.normal.z;
    out.colour = vec4f(linear(corner.colour.rgb), corner.colour.a);
    return out;
}

@fragment
fn fs_glow(in: Glow) -> @location(0) vec4f {
    let away = min(length(in.place), 1.0);
    let soft = (1.0 - away * away) * (1.0 - away * away);
    let alpha = in.colour.a * view.background.w * soft * soft;
    return vec4f(in.colour.rgb * alpha, alpha * view.sky.w);
}
