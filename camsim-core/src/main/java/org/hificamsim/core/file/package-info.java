/** Files that appear as a whole or not at all, and safe reading of text and XML of any size. */
package org.hificamsim.core.file;
