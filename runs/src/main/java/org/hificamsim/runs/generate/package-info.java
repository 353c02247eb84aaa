/** Scenarios made at random, of any size. */
package org.hificamsim.runs.generate;
