#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# agreement.sh PROJECT PROVED CHECKER FATHOM   the extracted checker and fathom-check give the same verdict on thousands of damaged
#                                              certificates, and accept none that claims something untrue; the extracted one has the
#                                              full score on the known faults, and draws the limits of the format where fathom-check and
#                                              check.py do. Certificates about two bodies, in format_5/two_bodies, are left out: it does
#                                              not read them, which is seen here too.
project=$1
tests=$project/tests/check
python3 -B "$project/verify/check/score.py" --without format5-two-bodies "$2" || exit 1
for limits in limits union_limits patch_limits tiling_limits impact_limits; do python3 -B "$tests/$limits.py" --checker "$2" || exit 1; done
python3 -B "$tests/union_forgeries.py" --checker "$2" --checker "$3" --fathom "$4" --count 6000 --seed 9 || exit 1
python3 -B "$tests/tiling_forgeries.py" --checker "$2" --checker "$3" --count 1000 --seed 7 "$project"/tests/data/certificates/format_5/*.cert || exit 1
python3 -B "$tests/forgeries.py" --checker "$2" --checker "$3" --oracle "$4" --count 4000 --patches 200 --seed 6 \
  "$project/tests/data/certificates/format_4" || exit 1
python3 -B "$tests/plane_forgeries.py" --checker "$2" --checker "$3" --seed 3 "$project/tests/data/certificates/plane" || exit 1
python3 -B "$tests/impact_forgeries.py" --checker "$2" --checker "$3" --count 6000 --seed 8 "$project"/tests/data/certificates/format_6/*.cert || exit 1
for file in "$project"/tests/data/certificates/format_5/two_bodies/*.cert "$project/tests/data/certificates/plane/two_bodies/two_unions.cert"; do
  said=$("$2" "$file")
  case $said in
    "s MALFORMED "*": a certificate about two bodies, which are solids or unions, is not read by this checker: use fathom-check") ;;
    *) echo "$file: $said"; exit 1 ;;
  esac
done
exec python3 -B "$tests/forgeries.py" --checker "$2" --checker "$3" --oracle "$4" --count 10000 --solids 300 --seed 5 \
  "$project/tests/data/certificates" "$project/tests/data/certificates/format_2" "$project/proofs/coq/examples/proved_width.cert" "$project/proofs/coq/examples/proved_statuses.cert"
