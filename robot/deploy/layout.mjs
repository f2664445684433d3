// The layout of ~/foresight on a robot, and the shell commands that change it.
//
//   staging/            a version that is being sent; nothing runs from here
//   versions/NAME/      bin/foresight-robot, etc/settings, etc/robot.json, etc/strategies/, foresight, foresight.service; of a
//                       robot that has the body nao also guardian/
//   current, previous   links to two of them
//   guardian/           the owner of LoLA, a copy from a version; a new version replaces it only without stiffness
//   logs/ state/        written by the runtime; no deployment touches them
//   made                changes outside of this folder, one per line, for --undo:
//                       folder PATH, file PATH, key LINE, root linger, root priority; paths are below the home

/** Makes our ~/foresight; fails if there is one that is not ours. */
export const kPrepare = `
if [ -e foresight ] && [ ! -e foresight/made ]; then
  echo "there is a ~/foresight on the robot that is not ours: expected none, or one with the file made" >&2
  exit 1
fi
mkdir -p foresight/logs foresight/state && : >>foresight/made`;

/** Points the link $1 to $2. If mv supports -T, the old or the new link exists at any moment. */
const kPoint = `
point() {
  rm -f "$1.new"
  ln -s "$2" "$1.new"
  mv -T "$1.new" "$1" 2>/dev/null || { rm -f "$1.new"; ln -sfn "$2" "$1"; }
}`;

/** If this user has a systemd, installs and enables the unit file $1. Each new file and folder is noted first. */
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

/** Removes the unit with the file name $1; its notes in `made` do no harm. */
const kForgetUnit = `
forget_unit() {
  rm -f ~/.config/systemd/user/$1 ~/.config/systemd/user/default.target.wants/$1
}`;

/** Stops the current version; after a failure before the next start it is started again. */
const kStopToSwap = `
if [ -e current ]; then
  trap '[ $? -eq 0 ] || current/foresight start' EXIT
  current/foresight stop
fi`;

/**
 * Makes the staged version the current one, with `name`, and starts it if `restart`. It is one command, so a broken connection
 * does not leave the robot without a runtime.
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

/** Makes the previous version the current one again and starts it. Prints `previous`, or `none` if there is none. */
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

/**
 * Stops the guardian if the robot has no stiffness. Otherwise, and if the state is not known, it only prints the state of the
 * robot and returns the exit status of `foresight-guardian --status`.
 */
const kStopGuardian = `
stop_guardian() {
  if guardian/guardian status >/dev/null; then
    how=$(guardian/bin/foresight-guardian --status 2>&1) || { answer=$?; echo "$how"; return $answer; }
  fi
  guardian/guardian stop
}`;

/**
 * Installs and starts the staged guardian, or removes one that is no longer wanted. Prints `same`, `new` or `none`. If the
 * robot has stiffness, it prints `kept` and the state of the robot; if the state is not known, `unknown` and the reason.
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
  how=$(stop_guardian) || { if [ $? -eq 1 ]; then echo "kept $how"; else echo "unknown $how"; fi; exit; }
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

/** Asks the guardian: the exit status of `foresight-guardian --status`, or 4 and its log if it does not run. */
export const kGuardianStatus = `
cd foresight
guardian/guardian status >/dev/null || { guardian/guardian log; exit 4; }
guardian/bin/foresight-guardian --status`;

/** Puts the previous guardian back and starts it; without a previous one, none runs. */
export const kPutGuardianBack = `
cd foresight
${kForgetUnit}
guardian/guardian stop || :
rm -rf guardian
if [ -e guardian.old ]; then mv guardian.old guardian && guardian/guardian start; else forget_unit foresight-guardian.service; fi`;

/** Stops the runtime and the guardian. If the robot has stiffness, or may have, it stops neither and says why. */
export const kStopAll = `
cd foresight
${kStopGuardian}
if [ -e guardian ]; then
  how=$(stop_guardian) || {
    if [ $? -eq 1 ]; then found="the robot has stiffness"; else found="the robot may have stiffness"; fi
    echo "$found ($how): it must sit first, by three fingers on its head" >&2
    exit 1
  }
fi
if [ -e current ]; then current/foresight stop; fi`;
