# Completion of vitrinectl for bash. The commands come from the program itself.
_vitrinectl() {
    local word=${COMP_WORDS[COMP_CWORD]} command='' operands i
    for ((i = 1; i < COMP_CWORD; i++)); do
        case ${COMP_WORDS[i]} in -*) ;; *) command=${COMP_WORDS[i]}; break ;; esac
    done
    if [[ -z $command ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(vitrinectl --commands | cut -d ' ' -f 1 | uniq) --json --help" -- "$word")
        return
    fi
    operands=$(vitrinectl --commands | grep "^$command ")
    if [[ $command == layout ]] && ((COMP_CWORD == i + 1)); then
        mapfile -t COMPREPLY < <(compgen -W "$(cut -d ' ' -f 2 <<< "$operands")" -- "$word")
    elif [[ $command == layout ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(vitrinectl layout list 2> /dev/null)" -- "$word")
    elif [[ $operands == *' off' ]] && ((COMP_CWORD > i + 1)); then
        mapfile -t COMPREPLY < <(compgen -W off -- "$word")
    elif [[ $operands == *FILE* || $operands == *.png* ]]; then
        compopt -o filenames
        mapfile -t COMPREPLY < <(compgen -f -- "$word")
    else
        mapfile -t COMPREPLY < <(compgen -W --json -- "$word")
    fi
}
complete -F _vitrinectl vitrinectl
