/** A run as a text that others can rebuild it from: the ODD protocol. */
package org.hificamsim.presentation.odd;
