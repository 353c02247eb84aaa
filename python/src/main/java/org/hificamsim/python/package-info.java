/**
 * The Java side of the Python package: worlds that are opened by a request in JSON, and stepped by
 * calls or over a pipe.
 */
package org.hificamsim.python;
