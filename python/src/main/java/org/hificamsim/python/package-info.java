/** What the Python package talks to: worlds opened by a text, stepped by calls or over a pipe. */
package org.hificamsim.python;
