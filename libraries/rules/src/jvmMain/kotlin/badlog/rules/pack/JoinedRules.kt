package badlog.rules.pack

import badlog.rules.Alias
import badlog.rules.DeviceNames
import badlog.rules.RuleSet

/**
 * Returns these rules of a folder, joined with the rules of [packs]. No two packs have a rule of the same name. A pack's rule replaces a
 * built-in rule of the same name, and is dropped if the folder has its own rule of that name. The names of signals are not changed.
 */
internal fun RuleSet.and(packs: List<RulePack>): RuleSet {
    if (packs.isEmpty()) return this
    val own = rules.filter { !it.isBuiltIn }.mapTo(HashSet()) { it.name }
    val added = packs.flatMap { it.rules.rules }.filter { it.name !in own }
    val names = added.mapTo(HashSet()) { it.name }
    return RuleSet(
        (aliases + packs.flatMap { it.rules.aliases }).distinctBy { it.name },
        rules.filter { it.name !in names } + added,
        signals,
        packs.fold(causes) { all, pack -> all.after(pack.causes) },
        comparisons,
        DeviceNames(packs.flatMap { it.rules.devices.devices }),
    )
}

/**
 * Checks that [pack] can be used with these rules and the packs [before] it.
 *
 * @throws PackException if the same name would mean two things.
 */
internal fun RuleSet.requireFree(pack: RulePack, before: List<RulePack>) {
    for (other in before) {
        val both = other.rules.rules.map { it.name }.find { name -> pack.rules.rules.any { it.name == name } } ?: continue
        throw PackException("${pack.path} and ${other.path} both have a rule “$both”; rename one of them.")
    }
    val known = aliases + before.flatMap { it.rules.aliases }
    val taken = pack.rules.aliases.find { alias -> known.any { it.name == alias.name && !it.means(alias) } } ?: return
    throw PackException("The alias “${taken.name}” of ${pack.path} already means other topics; rename it there.")
}

private fun Alias.means(other: Alias) = names == other.names && unit == other.unit
