/**
 * What happened in a run, step by step, for whoever looks at it: a page, a picture, a live view.
 */
package org.hificamsim.presentation.replay;
