/** What happened in a run, step by step, for pages, pictures and the live view. */
package org.hificamsim.presentation.replay;
