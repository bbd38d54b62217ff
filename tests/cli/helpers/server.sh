# SPDX-License-Identifier: AGPL-3.0-or-later
# For test scripts (sourced, after tap.sh): a command of integral that serves a page, and curl.
#
#   server_starts WORDS...   starts integral with these words; fills $address (with the token), $at
#                            (http://HOST:PORT) and $host; its output is in the files out and errors
#   no_server                whether this build serves no pages
#   server_ends [SIGNAL]     fills $status
#   ask_for CURL_OPTIONS...  prints the status; the answer is in the file got

server_starts() {
    : > out # the background process may open it later than the first look
    "$INTEGRAL" "$@" > out 2> errors &
    server=$!
    for ((k = 0; k < 600; ++k)); do
        address=$(grep -o 'http://[^ ]*' out || true)
        [ -z "$address" ] && kill -0 $server 2> /dev/null || break
        sleep 0.1
    done
    host=${address#http://} host=${host%%/*} at=http://$host
}
no_server() { [ -z "$address" ] && grep -q 'this build serves no pages' errors; }
server_ends() {
    [ -z "${1:-}" ] || kill -s "$1" $server
    status=0; wait $server || status=$?
}
ask_for() { curl -s -o got -w '%{http_code}' "$@"; }
