package badlog.viewer.choices

/**
 * Returns this list, which several tabs or windows change and remember in one place, with what the others have changed meanwhile: what
 * is [stored] now but was not when this one [read] it was added, what was and is not was removed. Whatever this one added or removed
 * itself stays so. Without changes of others, it is the same list.
 *
 * @param key returns what makes an element the same as another.
 */
fun <T> List<T>.mergedWith(stored: List<T>, read: List<T>, key: (T) -> Any? = { it }): List<T> {
    val removed = read.mapTo(HashSet(), key) - stored.mapTo(HashSet(), key)
    val known = (read + this).mapTo(HashSet(), key)
    val added = stored.filter { key(it) !in known }
    return if (removed.isEmpty() && added.isEmpty()) this else filterNot { key(it) in removed } + added
}
