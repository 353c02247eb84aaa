// The theme makes tables scroll; this makes them scroll by the keyboard, too.
addEventListener('load', () =>
  document.querySelectorAll('.md-typeset__scrollwrap').forEach(table => {
    table.tabIndex = 0;
  }),
);
