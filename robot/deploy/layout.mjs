// How ~/foresight on a robot is laid out, and the lines of shell that change it.
//
//   staging/            a version that is arriving; nothing runs from here
//   versions/NAME/      bin/foresight-robot, etc/settings, etc/robot.json, foresight, foresight.service; of a robot that has
//                       the body nao also guardian/
//   current, previous   links to two of them
//   guardian/           who owns LoLA, a copy of a version's: it stays when versions change, until the robot has no stiffness
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

/** Where this user has a systemd, our unit $1, a file, is there and starts with it; what was made for that is noted first. */
const kInstallUnit = `
install_unit() {
  if [ -z "\${XDG_RUNTIME_DIR:-}" ]; then export XDG_RUNTIME_DIR="/run/user/$(id -u)"; fi
  systemctl --user show-environment >/dev/null 2>&1 || return 0
  units=.config/systemd/user
  for folder in .config .config/systemd $units $units/default.target.wants; do
    if [ ! -d ~/$folder ]; then echo "folder $folder" >>made; mkdir ~/$folder; fi
  done
  name=$(basename "$1")
  if [ ! -e ~/$units/$name ]; then echo "file $units/$name" >>made; fi
  cp "$1" ~/$units/$name.new
  mv -f ~/$units/$name.new ~/$units/$name
  link=$units/default.target.wants/$name
  if [ ! -e ~/$link ]; then echo "file $link" >>made; ln -s ../$name ~/$link; fi
}`;

/** The unit $1, a file's name, is gone; what was noted of it does no harm. */
const kForgetUnit = `
forget_unit() {
  rm -f ~/.config/systemd/user/$1 ~/.config/systemd/user/default.target.wants/$1
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
install_unit current/foresight.service
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

/** Stops the guardian unless the robot has stiffness: then nothing is done, and it says how the robot is. */
const kStopGuardian = `
stop_guardian() {
  if guardian/guardian status >/dev/null; then
    how=$(guardian/bin/foresight-guardian --status 2>&1) || { echo "$how"; return 1; }
  fi
  guardian/guardian stop
}`;

/**
 * Makes the guardian that was staged the one that runs, or takes away one that is not wanted any more. Says `same`, `new`,
 * `none`, or `kept` and how the robot is, which has stiffness.
 */
export const kSwapGuardian = `
set -e
cd foresight
${kInstallUnit}
${kForgetUnit}
${kStopGuardian}
if [ ! -e staging/guardian ] && [ ! -e guardian ]; then echo none; exit; fi
if [ -e guardian ]; then
  if diff -r staging/guardian guardian >/dev/null 2>&1 && guardian/guardian status >/dev/null; then echo same; exit; fi
  how=$(stop_guardian) || { echo "kept $how"; exit; }
  rm -rf guardian.old
  mv guardian guardian.old
fi
if [ ! -e staging/guardian ]; then
  forget_unit foresight-guardian.service
  rm -rf guardian.old
  echo none
  exit
fi
cp -R staging/guardian guardian
install_unit guardian/foresight-guardian.service
guardian/guardian start
echo new`;

/** Whether the guardian answers: exit status 0 or 1, as the robot has no stiffness or some; else what it said. */
export const kGuardianStatus = `
cd foresight
guardian/guardian status >/dev/null || { guardian/guardian log; exit 4; }
guardian/bin/foresight-guardian --status`;

/** Puts the guardian back that ran before; where there was none, none runs. */
export const kPutGuardianBack = `
cd foresight
${kForgetUnit}
guardian/guardian stop || :
rm -rf guardian
if [ -e guardian.old ]; then mv guardian.old guardian && guardian/guardian start; else forget_unit foresight-guardian.service; fi`;

/** The runtime and the guardian end; a robot that has stiffness keeps both, and says how it is. */
export const kStopAll = `
cd foresight
${kStopGuardian}
if [ -e guardian ]; then
  how=$(stop_guardian) || { echo "the robot has stiffness ($how): it must sit first, by three fingers on its head" >&2; exit 1; }
fi
if [ -e current ]; then current/foresight stop; fi`;
