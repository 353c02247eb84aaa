// Makes the tables that the theme lets scroll reachable by the keyboard.
addEventListener('load', () =>
  document.querySelectorAll('.md-typeset__scrollwrap').forEach(table => {
    table.tabIndex = 0;
  }),
);
