# A hand for a real window, to be sourced: pointer and keys by X events, and widgets by their paths, from the file that
# `sward edit --widgets` writes. Needs $widgets (that file), $work (a folder of its own) and a fail function.

# Waits up to $patience seconds (120) until a command succeeds.
until_true() {
  local what=$1 i
  shift
  for i in $(seq $((${patience:-120} * 10))); do
    if "$@" >/dev/null 2>&1; then return 0; fi
    sleep 0.1
  done
  fail "waited in vain for $what"
}

# Whether a command succeeds within so many seconds.
within() {
  local i seconds=$1
  shift
  for i in $(seq $((seconds * 10))); do
    if "$@" >/dev/null 2>&1; then return 0; fi
    sleep 0.1
  done
  return 1
}

# --- what the window says
field() { awk -F'\t' -v path="$1" -v n="$2" '$1 == path { print $n; exit }' "$widgets"; } # of a widget's line
value() { field "$1" 7; }
there() { [ -n "$(field "$1" 2)" ]; }
in_sight() { case "$(field "$1" 6)" in *v*) return 0 ;; *) return 1 ;; esac; }
gone() { ! there "$1"; }
is() { [ "$(value "$1")" = "$2" ]; }
says() { case "$(value "$1")" in *"$2"*) return 0 ;; *) return 1 ;; esac; }
middle() { awk -F'\t' -v path="$1" '$1 == path { print int(($2 + $4) / 2), int(($3 + $5) / 2); exit }' "$widgets"; }

# What is in sight of the same panel and column: there the wheel moves the widget, too.
beside() {
  awk -F'\t' -v path="$1" '
    { x[$1] = $2; if ($6 ~ /v/) seen[$1] = int(($2 + $4) / 2) " " int(($3 + $5) / 2) }
    END {
      panel = substr(path, 1, index(path, "/"))
      for (other in seen) if (index(other, panel) == 1) { any = seen[other]; if (x[other] == x[path]) same = seen[other] }
      print same ? same : any
    }' "$widgets"
}

# --- the hand: each step longer than a frame or two. What is slower waits in the editor's queue of input.
rest() { sleep "${1:-0.15}"; }
at() { xdotool mousemove "$1" "$2"; rest; }
click() { # x y, and the button
  at "$1" "$2"
  xdotool mousedown "${3:-1}"
  rest
  xdotool mouseup "${3:-1}"
  rest
}
key() { for k in "$@"; do xdotool key "$k"; rest; done; }
drag() { # from x y to x y
  at "$1" "$2"
  xdotool mousedown 1
  rest
  local i
  for i in 1 2 3 4 5 6 7 8; do xdotool mousemove $(($1 + ($3 - $1) * i / 8)) $(($2 + ($4 - $2) * i / 8)); sleep 0.05; done
  rest
  xdotool mouseup 1
  rest
}

# --- widgets by their paths
# Waits for a widget, and scrolls what holds it until it is in sight: down to the end, then up.
find_widget() {
  local i
  until_true "the widget $1" there "$1"
  within 1 in_sight "$1" && return 0
  for i in $(seq 60); do
    if in_sight "$1"; then return 0; fi
    local scrolled=${2:-$(beside "$1")} button=5
    [ "$i" -gt 30 ] && button=4
    xdotool mousemove $scrolled click "$button"
    rest 0.2
  done
  fail "$1 does not come into sight"
}
# Until it stays where it is: a panel that opens moves what is beside it, on a busy machine some frames later.
stays() {
  local last now still=0 i
  last=$(middle "$1")
  for i in $(seq 40); do
    rest 0.12
    now=$(middle "$1")
    if [ "$now" = "$last" ]; then still=$((still + 1)); else still=0; fi
    last=$now
    if [ "$still" -ge 3 ]; then return 0; fi
  done
}
press() {
  find_widget "$1" "${2:-}"
  stays "$1"
  click $(middle "$1")
}
menu() { # File "New..."
  local i item="Menu/$1/$2"
  for i in 1 2 3; do # an open menu gives way to another one that the pointer comes over
    gone "$item" && press "Menu/$1"
    if within 20 in_sight "$item"; then
      stays "$item"
      click $(middle "$item")
      return 0
    fi
  done
  fail "the menu $1 does not show $2"
}
tab() { press "Tabs/$1"; }
choose() { # of a list, by an item's whole text
  find_widget "$1" "${3:-}"
  is "$1" "$2" && return 0
  stays "$1"
  click $(middle "$1")
  until_true "the item $2 of $1" there "$1/$2"
  find_widget "$1/$2" "$(middle "$1" | awk '{ print $1, $2 + 60 }')"
  stays "$1/$2"
  click $(middle "$1/$2")
}
write() { # into a line of text
  press "$1" "${3:-}"
  key ctrl+a
  xdotool type --delay 15 -- "$2"
  rest
  key Return
}
number() { # into a slider
  find_widget "$1" "${3:-}"
  stays "$1"
  xdotool keydown ctrl
  rest
  click $(middle "$1")
  xdotool keyup ctrl
  rest 0.3
  key ctrl+a
  xdotool type --delay 15 -- "$2"
  rest
  key Return
}

# The X server and, unless $unmanaged, a window manager that makes every window as large as the screen.
open_screen() { # width height
  Xvfb -displayfd 3 -screen 0 "$1x$2x24" -nolisten tcp -fbdir "$work" 3>"$work/display" >/dev/null 2>&1 &
  pids+=($!)
  until_true "the X server" test -s "$work/display"
  DISPLAY=:$(cat "$work/display")
  export DISPLAY
  [ -z "${unmanaged:-}" ] || return 0
  matchbox-window-manager -use_titlebar no >/dev/null 2>&1 &
  pids+=($!)
}
shot() { [ -z "${SHOTS:-}" ] || cp "$work/Xvfb_screen0" "$SHOTS/$1.xwd"; } # a picture, for who wants to look
