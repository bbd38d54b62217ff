# SPDX-License-Identifier: AGPL-3.0-or-later
# For test scripts (sourced): how near two pictures are.
#
#   psnr A B        prints PSNR in dB; 999 if they are equal
#   at_least P Q    whether P is at least Q

psnr() { "$INTEGRAL" compare "$1" "$2" --json | tr ',{}' '\n' | sed -n 's/.*"psnr[^:]*" *: *\([0-9.]\{1,\}\|null\).*/\1/p' | sed 's/null/999/' | head -1; }
at_least() { echo "PSNR $1 dB"; awk "BEGIN { exit !($1 >= $2) }"; }
