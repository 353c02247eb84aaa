/** Policies whose cameras ask their neighbours before they decide (thesis 7.4.5). */
package org.hificamsim.agents.voting;
