/** The ladder: how much realism the choice of a policy needs, judged by the top rung. */
package org.hificamsim.reproduction.ladder;
