/** Heat maps: the coverage of each cell of a field, and the visits of targets. */
package org.hificamsim.runs.heat;
