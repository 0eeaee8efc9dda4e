// SPDX-License-Identifier: MIT
// Buttons that copy the command beside them. From a disk there may be no clipboard: then the command is selected.
{
  const select = (element) => {
    const range = document.createRange();
    range.selectNodeContents(element);
    getSelection().removeAllRanges();
    getSelection().addRange(range);
  };

  for (const button of document.querySelectorAll(".copy")) {
    const word = button.firstElementChild;
    const command = document.getElementById(button.dataset.copies);
    let back = 0;
    const say = (text) => {
      word.textContent = text;
      clearTimeout(back);
      back = setTimeout(() => (word.textContent = "Copy"), 2000);
    };
    button.addEventListener("click", async () => {
      try {
        await navigator.clipboard.writeText(command.textContent);
        say("Copied");
      } catch {
        select(command);
        say(document.execCommand?.("copy") ? "Copied" : "Selected");
      }
    });
    button.hidden = false;
  }
}
