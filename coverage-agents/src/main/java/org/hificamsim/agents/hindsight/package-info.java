/** Policies that know the whole run beforehand. */
package org.hificamsim.agents.hindsight;
