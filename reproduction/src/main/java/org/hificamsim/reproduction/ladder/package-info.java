/** How much realism the choice of a policy needs: rungs of realism, judged by the top one. */
package org.hificamsim.reproduction.ladder;
