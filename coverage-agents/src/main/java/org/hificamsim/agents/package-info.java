/** The zoom policies of chapter 7, registered by name. */
package org.hificamsim.agents;
