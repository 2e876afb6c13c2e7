package badlog.season.sql

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.contentOrNull

/**
 * The tables and functions that a query reads, according to DuckDB's own parser. A confined query may read only the tables of a lake: no
 * files by name, no settings, and none of DuckDB's own tables, which reveal where the lake's files are.
 */
internal class QuerySources private constructor(private val ownNames: Set<String>) {
    private fun check(element: JsonElement) {
        if (element is JsonArray) return element.forEach(::check)
        if (element !is JsonObject) return
        when (element.text("type")) {
            "BASE_TABLE" -> checkTable(element)
            "TABLE_FUNCTION" -> checkTableFunction(element)
            "SHOW_REF" -> element.text("table_name")?.takeIf { it.isNotEmpty() }?.let { checkName(it.removeSurrounding("\"")) }
        }
        if (element.text("class") == "FUNCTION") {
            val name = element.text("function_name").orEmpty().lowercase()
            if (name in SETTINGS) throw SqlException("The function $name is not available here.")
        }
        element.values.forEach(::check)
    }

    private fun checkTable(table: JsonObject) {
        if (listOf("schema_name", "catalog_name").any { !table.text(it).isNullOrEmpty() }) refuse(table.text("table_name").orEmpty())
        checkName(table.text("table_name").orEmpty())
    }

    private fun checkName(name: String) {
        if (name.lowercase() !in TABLES && name.lowercase() !in ownNames) refuse(name)
    }

    private fun checkTableFunction(function: JsonObject) {
        val name = (function["function"] as? JsonObject)?.text("function_name").orEmpty().lowercase()
        if (name !in FUNCTIONS) {
            throw SqlException("The table function $name is not available here; query the tables: ${TABLES.joinToString()}.")
        }
    }

    private fun refuse(name: String): Nothing = throw SqlException("There is no table “$name” here; there are ${TABLES.joinToString()}.")

    companion object {
        private val TABLES = LakeView.entries.map { it.sqlName }.toSet()

        /** Table functions that only use their arguments. */
        private val FUNCTIONS = setOf("unnest", "range", "generate_series", "json_each", "json_tree")
        private val SETTINGS = setOf("current_setting", "getenv", "getvariable")

        /** Excludes the prefixes of DuckDB's own tables, and characters that file names need. */
        private val OWN_NAME = Regex("(?!duckdb|pragma|sqlite|pg_)[a-z_][a-z0-9_]*")

        /**
         * Checks that the query reads only the tables of a lake and its own common table expressions.
         *
         * @param parsed the query as DuckDB serializes it.
         *
         * @throws SqlException if it reads anything else.
         */
        fun require(parsed: JsonElement) {
            val names = HashSet<String>()
            collectOwnNames(parsed, names)
            names.firstOrNull { !OWN_NAME.matches(it) }?.let {
                throw SqlException("“$it” cannot be the name of a common table expression here; use letters, digits and _.")
            }
            QuerySources(names).check(parsed)
        }

        private fun collectOwnNames(element: JsonElement, names: MutableSet<String>) {
            when (element) {
                is JsonArray -> element.forEach { collectOwnNames(it, names) }

                is JsonObject -> {
                    val map = (element["cte_map"] as? JsonObject)?.get("map") as? JsonArray
                    map?.mapNotNullTo(names) { (it as? JsonObject)?.text("key")?.lowercase() }
                    element.values.forEach { collectOwnNames(it, names) }
                }

                else -> Unit
            }
        }

        private fun JsonObject.text(name: String): String? = (this[name] as? JsonPrimitive)?.contentOrNull
    }
}
