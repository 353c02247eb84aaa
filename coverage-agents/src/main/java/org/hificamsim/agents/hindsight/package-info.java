/** Policies that know the whole run before it starts. */
package org.hificamsim.agents.hindsight;
