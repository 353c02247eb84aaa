/**
 * Warnings about a scenario or a comparison before it is run: what it cannot show, or how long it
 * will take.
 */
package org.hificamsim.runs.hints;
