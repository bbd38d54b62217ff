# SPDX-License-Identifier: AGPL-3.0-or-later
# For test scripts (sourced, after tap.sh): a Chromium without a window, driven through its own pipe
# (DevTools protocol).
#
#   browser_starts                      false if there is none, or it does not start; $browser_trouble says why
#   browse URL                          opens a page
#   evaluate 'EXPRESSION'               prints the value of JavaScript; of a promise, its value when it has one
#   ask METHOD '{"parameters": 1}'      any command; its answer is in $answer
#   window WIDTH HEIGHT [MOBILE [SCALE]]
#                                       the page's size; MOBILE: true or false; SCALE: device pixels for each
#                                       pixel of the page (1), fewer where WebGL's pictures do not matter
#   screenshot FILE.png                 of that size
#   browser_ends

browser_starts() {
    local browser= name
    for name in chromium chromium-browser google-chrome; do
        [ -n "$browser" ] || browser=$(command -v $name || true)
    done
    [ -n "$browser" ] || { browser_trouble="there is no Chromium"; return 1; }
    trap '' PIPE # where it has ended, writing to it fails
    mkdir -p "$scratch/browser/home"
    mkfifo "$scratch/browser/to" "$scratch/browser/from"
    HOME=$scratch/browser/home timeout -k 5 ${BROWSER_SECONDS:-300} "$browser" --headless=new --no-sandbox --disable-gpu-sandbox \
        --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --disable-dev-shm-usage --no-first-run \
        --hide-scrollbars --force-color-profile=srgb --user-data-dir="$scratch/browser/profile" --remote-debugging-pipe about:blank \
        3< "$scratch/browser/to" 4> "$scratch/browser/from" > "$scratch/browser/log" 2>&1 &
    browser_process=$!
    exec {browser_to}> "$scratch/browser/to" {browser_from}< "$scratch/browser/from"
    browser_session= browser_asked=0
    browser_trouble="$browser does not start"
    ask Target.createTarget '{"url": "about:blank"}' || return 1
    local target=${answer#*\"targetId\":\"}
    ask Target.attachToTarget "{\"targetId\": \"${target%%\"*}\", \"flatten\": true}" || return 1
    browser_session=${answer#*\"sessionId\":\"}
    browser_session=${browser_session%%\"*}
}

ask() {
    browser_asked=$((browser_asked + 1))
    printf '{"id": %d, %s"method": "%s", "params": %s}\0' $browser_asked \
        "${browser_session:+\"sessionId\": \"$browser_session\", }" "$1" "$2" >&$browser_to 2>/dev/null || return 1
    while IFS= read -r -d '' -t 60 answer <&$browser_from; do
        case $answer in
        "{\"id\":$browser_asked,\"error\""*) echo "$1: $answer" >&2; return 1 ;;
        "{\"id\":$browser_asked,"*) return 0 ;;
        esac
    done
    return 1
}

browse() { ask Page.navigate "{\"url\": \"$1\"}"; }

evaluate() {
    local text=${1//\\/\\\\}
    ask Runtime.evaluate \
        "{\"expression\": \"${text//\"/\\\"}\", \"awaitPromise\": true, \"returnByValue\": true}" \
        || return 1
    case $answer in *exceptionDetails*) echo "$answer"; return 1 ;; esac
    text=${answer#*\"value\":}
    text=${text%%\}*}
    text=${text%%,\"description\"*}
    text=${text#\"}
    printf '%s\n' "${text%\"}"
}

window() {
    browser_clip="{\"x\": 0, \"y\": 0, \"width\": $1, \"height\": $2, \"scale\": 1}"
    ask Emulation.setDeviceMetricsOverride \
        "{\"width\": $1, \"height\": $2, \"deviceScaleFactor\": ${4:-1}, \"mobile\": ${3:-false}}"
}

screenshot() {
    ask Page.captureScreenshot "{\"format\": \"png\", \"clip\": $browser_clip}" || return 1
    local data=${answer#*\"data\":\"}
    printf '%s' "${data%%\"*}" | base64 -d > "$1"
}

browser_ends() {
    browser_session=
    ask Browser.close '{}' > /dev/null 2>&1 || true
    wait $browser_process || true
}
