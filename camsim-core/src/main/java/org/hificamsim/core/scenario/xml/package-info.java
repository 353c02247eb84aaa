/** XML as elements with their places in the file, and its writer. */
package org.hificamsim.core.scenario.xml;
