#!/bin/sh
# Makes the fonts of this folder from DejaVu 2.37 (Debian: fonts-dejavu-core) with fonttools (PyPI), without hints and features.
#     ./subset.sh [FOLDER OF THE FONTS]
set -eu
from=${1:-/usr/share/fonts/truetype/dejavu}
here=$(dirname "$0")
latin=U+0020-007E,U+00A0-00FF,U+2013,U+2014,U+2018-201E,U+2026,U+2212
names=U+0020-007E,U+00A0-017F,U+0370-03FF,U+0400-045F,U+0490-0491,U+2010-2015,U+2018-201E,U+2020-2022,U+2026,U+2030,U+2032-2033
names=$names,U+2039-203A,U+20AC,U+2190-2195,U+2212,U+2248,U+2260,U+2264-2265,U+25A1
subset() {
    pyftsubset "$from/$1.ttf" --unicodes="$2" --output-file="$here/$1.ttf" --no-hinting --layout-features='' --name-IDs=0 \
        --drop-tables+=GSUB,GPOS,GDEF,kern,FFTM --no-recalc-timestamp
}
subset DejaVuSans "$names"
subset DejaVuSans-Bold "$latin"
subset DejaVuSansMono "$names"
