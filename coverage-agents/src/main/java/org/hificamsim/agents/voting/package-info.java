/** Policies whose cameras ask their neighbours before they decide (section 7.4.5). */
package org.hificamsim.agents.voting;
