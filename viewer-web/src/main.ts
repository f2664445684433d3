import { mount } from "svelte";
import "./app/base.css";
import App from "./app/App.svelte";
import Refusal from "./widgets/Refusal.svelte";
import { keep, kept, restoreTheme } from "./state/browser";
import { Viewer } from "./state/viewer.svelte";
import { targetOf } from "./source/target";

restoreTheme();
const page = document.getElementById("app")!;
const target = targetOf(location.href, (host) => kept("sessionStorage", `token ${host}`));

if ("error" in target) {
  mount(Refusal, { target: page, props: { sentence: target.error } });
} else {
  // the token leaves the address before anything else can read or share it
  if (target.token) keep("sessionStorage", `token ${target.host}`, target.token);
  if (target.cleanAddress !== location.href) history.replaceState(null, "", target.cleanAddress);
  mount(App, { target: page, props: { viewer: new Viewer(target) } });
}
