/** From photos to fitted detection models: chapters 3 to 6 as a tool. */
package org.hificamsim.profiling;
