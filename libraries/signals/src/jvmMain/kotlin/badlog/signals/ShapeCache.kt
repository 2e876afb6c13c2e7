package badlog.signals

import badlog.core.analysis.LogView

/** The results that [make] prepares for all logs of a shape, kept for the [max] shapes used last. Thread-safe; may prepare the same twice. */
class ShapeCache<V : Any>(private val max: Int, private val make: (LogShape) -> V) {
    private val kept = object : LinkedHashMap<LogShape, V>(16, 0.75f, true) {
        override fun removeEldestEntry(eldest: Map.Entry<LogShape, V>) = size > max
    }

    /** Returns the prepared result for [view], which needs no samples. */
    operator fun get(view: LogView): V {
        val shape = LogShape.of(view)
        synchronized(kept) { kept[shape] }?.let { return it }
        val made = make(shape)
        synchronized(kept) { kept[shape] = made }
        return made
    }
}
