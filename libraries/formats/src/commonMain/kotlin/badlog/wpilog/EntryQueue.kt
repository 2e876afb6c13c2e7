package badlog.wpilog

/** Entries in the order of their next samples: a heap, in which of two equal times the earlier entry comes first. */
internal class EntryQueue(entries: List<EntryWriter>) {
    private val heap = entries.indices.filter { entries[it].hasNext }.toIntArray()
    private val all = entries
    private var size = heap.size

    init {
        for (i in size / 2 - 1 downTo 0) sink(i)
    }

    /** The one whose next sample is the earliest; null when none has one left. */
    val first: EntryWriter? get() = if (size == 0) null else all[heap[0]]

    /** Finds the new place of [first], whose sample was taken. */
    fun moveFirst() {
        if (!all[heap[0]].hasNext) heap[0] = heap[--size]
        if (size > 1) sink(0)
    }

    private fun sink(from: Int) {
        var at = from
        while (true) {
            var least = at
            for (child in 2 * at + 1..minOf(2 * at + 2, size - 1)) if (isBefore(heap[child], heap[least])) least = child
            if (least == at) return
            val entry = heap[at]
            heap[at] = heap[least]
            heap[least] = entry
            at = least
        }
    }

    // What stands nowhere goes at once.
    private fun isBefore(one: Int, other: Int): Boolean {
        val x = all[one].nextX
        val y = all[other].nextX
        return if (x == y || (x.isNaN() && y.isNaN())) one < other else x < y || x.isNaN()
    }
}
