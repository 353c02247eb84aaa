/** Data sets of photos: what a folder holds, checked row by row before anything runs. */
package org.hificamsim.profiling.dataset;
