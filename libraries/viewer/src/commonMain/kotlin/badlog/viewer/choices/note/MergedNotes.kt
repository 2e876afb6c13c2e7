package badlog.viewer.choices.note

import badlog.viewer.choices.mergedWith

/**
 * Returns these notes, which several tabs or windows change and remember in one place, with what the others have changed since this one
 * [read] them, see [mergedWith]. Files have no names for notes: one at the moment of another that is gone is that one, with another text;
 * several at one moment are known by their texts.
 *
 * @param stored the notes as they are remembered now.
 */
fun List<Note>.notesMergedWith(stored: List<Note>, read: List<Note>): List<Note> {
    fun isAlone(x: Double) = read.any { it.x == x } && listOf(this, stored, read).all { notes -> notes.count { it.x == x } < 2 }
    return mergedWith(stored, read, key = { if (isAlone(it.x)) it.x else it }).sortedBy { it.x }
}
