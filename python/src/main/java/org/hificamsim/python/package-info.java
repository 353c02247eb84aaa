/**
 * The Java side of the Python package: worlds opened by a text, stepped by calls or over a pipe.
 */
package org.hificamsim.python;
