/** Files that appear whole or not at all; text and XML of any size, read safely. */
package org.hificamsim.core.file;
