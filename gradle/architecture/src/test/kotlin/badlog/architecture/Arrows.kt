package badlog.architecture

/** A dependency: [from] uses [to]. */
internal data class Arrow(val from: String, val to: String) {
    override fun toString() = "$from -> $to"
}

/** Returns the [arrows] that are part of a cycle, with a path from their end back to their start. */
internal fun circular(arrows: Set<Arrow>): Set<Arrow> {
    val next = arrows.groupBy({ it.from }, { it.to })
    val reached = next.keys.associateWith { start ->
        val seen = HashSet<String>()
        val open = ArrayDeque(listOf(start))
        while (open.isNotEmpty()) next[open.removeFirst()].orEmpty().filterTo(open) { seen.add(it) }
        seen
    }
    return arrows.filterTo(LinkedHashSet()) { it.from in reached[it.to].orEmpty() }
}

/** Returns the arrows between packages according to the imports of [files]; [packageOf] returns the package of an import. */
internal fun packageArrows(files: List<SourceFile>, packageOf: (String) -> String?): Set<Arrow> = files.flatMapTo(LinkedHashSet()) { file ->
    file.imports.mapNotNull(packageOf).filter { it != file.packageName }.map { Arrow(file.packageName, it) }
}

/** Returns the longest of [packages] that contains [import], which may be a member of a class or a package itself. */
internal fun packageOf(import: String, packages: Set<String>): String? = generateSequence(import) { it.substringBeforeLast('.', "").ifEmpty { null } }.firstOrNull { it in packages }
