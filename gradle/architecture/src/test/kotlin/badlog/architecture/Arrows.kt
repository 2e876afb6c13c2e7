package badlog.architecture

/** A dependency: [from] uses [to]. */
internal data class Arrow(val from: String, val to: String) {
    override fun toString() = "$from -> $to"
}

/** The [arrows] that are part of a cycle: those from whose end a path leads back to their start. */
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

/** The arrows between packages, by the imports of [files]; [packageOf] returns the package of an import. */
internal fun packageArrows(files: List<SourceFile>, packageOf: (String) -> String?): Set<Arrow> = files.flatMapTo(LinkedHashSet()) { file ->
    file.imports.mapNotNull(packageOf).filter { it != file.packageName }.map { Arrow(file.packageName, it) }
}

/** The longest of [packages] that contains [import]: what is imported may be inside a class, or be a package itself. */
internal fun packageOf(import: String, packages: Set<String>): String? = generateSequence(import) { it.substringBeforeLast('.', "").ifEmpty { null } }.firstOrNull { it in packages }
