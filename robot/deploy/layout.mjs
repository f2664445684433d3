// How ~/foresight on a robot is laid out, and the lines of shell that change it.
//
//   staging/            a version that is arriving; nothing runs from here
//   versions/NAME/      bin/foresight-robot, etc/settings, etc/robot.json, foresight, foresight.service
//   current, previous   links to two of them
//   logs/ state/        what the runtime writes; no deployment touches them
//   made                what was made or changed outside of this folder, a line each, for --undo:
//                       folder PATH, file PATH, key LINE, root linger, root priority; paths are below the home

/** Refuses a ~/foresight that is somebody else's, and makes ours. */
export const kPrepare = `
if [ -e foresight ] && [ ! -e foresight/made ]; then
  echo "there is a ~/foresight on the robot that is not ours: expected none, or one with the file made" >&2
  exit 1
fi
mkdir -p foresight/logs foresight/state && : >>foresight/made`;

/** Points the link $1 to $2: at any moment there is the old one or the new one, where mv knows -T. */
const kPoint = `
point() {
  rm -f "$1.new"
  ln -s "$2" "$1.new"
  mv -T "$1.new" "$1" 2>/dev/null || { rm -f "$1.new"; ln -sfn "$2" "$1"; }
}`;

/** Where this user has a systemd, our unit is there and starts with it; what was made for that is noted first. */
const kInstallUnit = `
install_unit() {
  if [ -z "\${XDG_RUNTIME_DIR:-}" ]; then export XDG_RUNTIME_DIR="/run/user/$(id -u)"; fi
  systemctl --user show-environment >/dev/null 2>&1 || return 0
  units=.config/systemd/user
  for folder in .config .config/systemd $units $units/default.target.wants; do
    if [ ! -d ~/$folder ]; then echo "folder $folder" >>made; mkdir ~/$folder; fi
  done
  if [ ! -e ~/$units/foresight.service ]; then echo "file $units/foresight.service" >>made; fi
  cp current/foresight.service ~/$units/foresight.service.new
  mv -f ~/$units/foresight.service.new ~/$units/foresight.service
  link=$units/default.target.wants/foresight.service
  if [ ! -e ~/$link ]; then echo "file $link" >>made; ln -s ../foresight.service ~/$link; fi
}`;

/** What fails between here and the start must not leave the robot with nothing that runs. */
const kStopToSwap = `
if [ -e current ]; then
  trap '[ $? -eq 0 ] || current/foresight start' EXIT
  current/foresight stop
fi`;

/**
 * Makes what was staged the current version, `name`, and starts it, unless it shall not. One command: a connection that is
 * cut in the middle does not leave the robot without a runtime.
 */
export const switchTo = (name, { restart }) => `
set -e
cd foresight
${kPoint}
${kInstallUnit}
${restart ? kStopToSwap : ""}
mkdir -p versions
mv staging versions/${name}
if [ -e current ]; then point previous "$(readlink current)"; fi
point current versions/${name}
for version in versions/*; do
  case $version in "$(readlink current)" | "$(readlink previous || :)") ;; *) rm -rf "$version" ;; esac
done
install_unit
${restart ? "current/foresight start" : ""}`;

/** Makes the previous version the current one again and starts it; where there is none, nothing runs. Says which. */
export const kRollBack = `
set -e
cd foresight
${kPoint}
bad=$(readlink current)
current/foresight stop || :
if [ -e previous ]; then
  point current "$(readlink previous)"
  rm -f previous
  current/foresight start
  echo previous
else
  rm -f current
  echo none
fi
rm -rf "$bad"`;
