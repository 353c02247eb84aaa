/** Experiments: the command line, runs, and the files that they write. */
package org.hificamsim.experiments;
