/** Files that appear whole or not at all, written here alone. */
package org.hificamsim.core.file;
