# What the scripts beside this file share: where things are, and the tools
# that they install where they are missing. To be sourced, from the root.

export CARGO_TARGET_DIR="${CARGO_TARGET_DIR:-${XDG_CACHE_HOME:-$HOME/.cache}/sinew/target}"
wasm=wasm32-unknown-unknown

# Says what to do where a tool is missing and cannot be installed.
missing() {
    echo "$0: $1" >&2
    return 1
}

wasm_target() {
    [ -d "$(rustc --print sysroot)/lib/rustlib/$wasm" ] && return
    command -v rustup >/dev/null ||
        missing "the target $wasm is missing and there is no rustup to install it" || return
    rustup target add "$wasm"
}

# The packages of web/package-lock.json, anew when that has changed.
node_packages() {
    command -v npm >/dev/null || missing "npm is missing; install Node.js 20 or newer" || return
    [ web/node_modules/.package-lock.json -nt web/package-lock.json ] && return
    npm ci --prefix web --no-audit --no-fund --loglevel=error &&
        touch web/node_modules/.package-lock.json
}

as_root() {
    if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi
}

# Debian's browser, or another Chromium on the path.
browser() {
    for name in chromium chromium-browser google-chrome; do
        BROWSER=$(command -v "$name") && export BROWSER && return
    done
    command -v apt-get >/dev/null || missing "Chromium is missing; install it" || return
    as_root apt-get install -y -qq --no-install-recommends chromium || {
        as_root apt-get update -qq &&
            as_root apt-get install -y -qq --no-install-recommends chromium
    } || missing "could not install chromium" || return
    BROWSER=$(command -v chromium) && export BROWSER
}
