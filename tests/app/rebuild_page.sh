#!/usr/bin/env bash
# Bundles the report's page anew and compares it with the one in the repository.
# Usage: rebuild_page.sh FOLDER_OF_PAGE. Exit status 77 where that takes what is not here.
set -euo pipefail
cd "$1"
if ! command -v node >/dev/null || [ ! -d node_modules/esbuild ]; then
    echo "skipped: needs node, and \`npm ci\` in $1"
    exit 77
fi
rebuilt=$(mktemp)
trap 'rm -f "$rebuilt"' EXIT
node build.js "$rebuilt"
if ! cmp "$rebuilt" ../page.html; then
    echo "app/report/page.html is not what its sources give; run \`npm run build\` in $1"
    exit 1
fi
