/** Scenarios made at random, of any size. */
package org.hificamsim.experiments.generate;
