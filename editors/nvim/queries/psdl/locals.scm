(module) @local.scope
(function_definition) @local.scope
(lambda) @local.scope
(list_comprehension) @local.scope
(assignment left: (identifier) @local.definition.var)
(function_definition name: (identifier) @local.definition.function)
(parameters (identifier) @local.definition.parameter)
(for_statement left: (identifier) @local.definition.var)
(identifier) @local.reference
