package badlog.catalog.examine

/** Caches the results of [make] for the [max] most recently used keys. Thread-safe; may make the same result twice. */
class LruCache<K : Any, V : Any>(private val max: Int, private val make: (K) -> V) {
    private val kept = object : LinkedHashMap<K, V>(16, 0.75f, true) {
        override fun removeEldestEntry(eldest: Map.Entry<K, V>) = size > max
    }

    operator fun get(key: K): V {
        synchronized(kept) { kept[key] }?.let { return it }
        val made = make(key)
        synchronized(kept) { kept[key] = made }
        return made
    }
}
