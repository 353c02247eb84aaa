/** Many plans side by side: run on all cores, safe to kill, summed up with intervals. */
package org.hificamsim.runs.compare;
