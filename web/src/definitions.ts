// A click on a defined word shows its definition beside it; without this script it is a link to it.
export function showDefinitions(root: ParentNode = document): void {
  const box = document.createElement("div");
  box.className = "definition";
  box.setAttribute("role", "dialog");
  box.setAttribute("aria-label", "Definition");
  box.hidden = true;
  document.body.append(box);
  let opener: HTMLElement | null = null;
  const close = (refocus: boolean) => {
    if (box.hidden) return;
    box.hidden = true;
    opener?.setAttribute("aria-expanded", "false");
    if (refocus) opener?.focus();
    opener = null;
  };
  root.addEventListener("click", (event) => {
    const link = (event.target as Element).closest?.("a.def") as HTMLAnchorElement | null;
    if (!link) {
      if (!box.contains(event.target as Node)) close(false);
      return;
    }
    const term = document.getElementById(link.hash.slice(1));
    if (!term) return;
    event.preventDefault();
    if (opener === link) {
      close(true);
      return;
    }
    close(false);
    opener = link;
    link.setAttribute("aria-expanded", "true");
    const text = term.nextElementSibling;
    box.innerHTML = `<strong>${term.innerHTML}</strong><div>${text ? text.innerHTML : ""}</div>`;
    const button = document.createElement("button");
    button.type = "button";
    button.className = "close";
    button.setAttribute("aria-label", "Close");
    button.textContent = "×";
    button.addEventListener("click", () => close(true));
    box.prepend(button);
    box.hidden = false;
    const at = link.getBoundingClientRect(), width = Math.min(400, window.innerWidth - 24);
    box.style.width = `${width}px`;
    box.style.left = `${window.scrollX + Math.max(12, Math.min(at.left, window.innerWidth - width - 24))}px`;
    const below = at.bottom + 8 + box.offsetHeight < window.innerHeight;
    box.style.top = `${window.scrollY + (below ? at.bottom + 6 : Math.max(8, at.top - box.offsetHeight - 6))}px`;
    button.focus({ preventScroll: true });
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") close(true);
  });
}
